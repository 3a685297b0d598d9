// The current vertex attributes and raster position (GL 1.5, 2.7 and 2.13; state table 6.5). All of
// it is GL_CURRENT_BIT.

#pragma once

#include "driver/gl_types.h"
#include "model/device/registers/geometry.h"
#include "model/device/registers/vertex.h"

#include <array>

namespace ffgpu::gl {

struct RasterPosition {
    bool valid = true;
    Vec4 position{0, 0, 0, 1}; // window x, y, z in [0, 1]; clip w
    float distance = 0;        // to the eye: the fog coordinate
    Vec4 color{1, 1, 1, 1};    // lit and clamped
    Vec4 secondary_color{0, 0, 0, 1};
    float color_index = 1;
    std::array<Vec4, TextureUnits> tex_coords = [] {
        std::array<Vec4, TextureUnits> all{};
        all.fill({0, 0, 0, 1});
        return all;
    }();
};

struct CurrentState {
    // By Attribute; Position is not used. Up to date whenever the phase is VertexPhase::Idle.
    CurrentAttributes attributes;
    float color_index = 1;
    RasterPosition raster;

    Vec4& of(Attribute attribute) { return attributes.values[static_cast<std::size_t>(attribute)]; }
    const Vec4& of(Attribute attribute) const {
        return attributes.values[static_cast<std::size_t>(attribute)];
    }
};

} // namespace ffgpu::gl
