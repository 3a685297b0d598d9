// DisplayList: what glNewList ... glEndList recorded (GL 1.5, 5.4): commands as a stream of
// records, and the vertices between glBegin and glEnd as blocks that are ready to be drawn.

#pragma once

#include "driver/objects/device_block.h"
#include "driver/vertex/vertex_run.h"
#include "model/device/registers/geometry.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace ffgpu::gl {

// The primitives of one or more glBegin/glEnd pairs with no other command between them, or of one
// array draw.
struct VertexBlock {
    VertexFormat format;
    std::vector<float> words;
    std::vector<RunPrimitive> primitives;
    // Of an array draw with indices: its only primitive's, into the words.
    std::vector<std::uint32_t> indices;

    // The attributes that the calls set (one bit each), as the last of them left them: they become
    // current.
    std::uint32_t sets = 0;
    std::array<Vec4, Attributes> last{};

    // So many of the first vertices have an attribute that the list had not set yet: they take the
    // value that is current when the list is executed.
    std::array<std::uint32_t, Attributes> inherited{};
    bool inherits = false;

    // Made by array draws, which are errors between glBegin and glEnd; glBegin itself is one there,
    // too, but the vertices behind it are not. They set no attribute for what follows.
    bool is_array_draw = false;

    DeviceBlock memory; // the words and indices, once the block was drawn

    VertexRun run() const { return {format, words, primitives}; }
};

struct DisplayList {
    std::vector<std::byte> code;
    std::vector<std::unique_ptr<VertexBlock>> blocks;
};

} // namespace ffgpu::gl
