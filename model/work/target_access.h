// What a draw's state lets it read and write of the samples that it covers in its targets (OpenGL
// 1.5, section 4.1.5 to 4.1.9 and 4.2.2): what must come from memory, and what has to go there.

#pragma once

#include "model/device/registers.h"
#include "model/work/surface_lines.h"

#include <cstdint>

namespace ffgpu::work {

// Of a sample of the depth target.
struct DepthAccess {
    bool tests_depth = false;   // Something depends on the stored depth.
    bool tests_stencil = false; // Something depends on the stored stencil value.
    PixelBytes depth;           // written where all tests pass
    // The stencil value's, written by how the tests end.
    PixelBytes passed, depth_failed, stencil_failed;

    bool reads() const { return tests_depth || tests_stencil; }
    // Of a sample's bytes, bit i for byte i.
    std::uint32_t bytes_read(Format format) const;
    bool writes() const {
        return (depth.touched | passed.touched | depth_failed.touched | stencil_failed.touched) !=
               0;
    }
};
DepthAccess depth_access(const Registers& state);

// Of a sample of a colour target that is written.
struct ColorAccess {
    bool reads = false; // What is written depends on what is there.
    PixelBytes written;
};
ColorAccess color_access(const Registers& state, unsigned target);

} // namespace ffgpu::work
