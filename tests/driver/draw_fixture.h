// A context on a recording device, and the draws that reached it with their vertices.

#pragma once

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/device/registers/vertex.h"
#include "tests/driver/recording_device.h"

#include <array>
#include <vector>

namespace ffgpu::gl {

struct DrawFixture {
    DrawFixture()
        : gl(device, {.width = 64, .height = 64}) {
        gl.make_current();
    }

    RecordingDevice device{32u << 20};
    OffscreenContext gl;

    // The draws since the last call; what waits to be merged is drawn first.
    std::vector<DrawCommand> draws() {
        gl.context().flush_vertices();
        std::vector<DrawCommand> all;
        for (const auto& command : device.commands)
            if (command.opcode == Opcode::Draw) all.push_back(command.as<DrawCommand>());
        device.forget();
        return all;
    }

    // An attribute of a vertex of a draw as the device fetches it; `i` counts the draw's vertices
    // in the order of drawing. The vertex format must still be the draw's.
    std::array<float, 4> attribute(const DrawCommand& draw, std::uint32_t i, Attribute a) const {
        const VertexFormat& format = device.registers.vertex_format;
        const VertexElement element = format.elements[static_cast<std::size_t>(a)];
        if (element.components == 0)
            return device.registers.current.values[static_cast<std::size_t>(a)];
        const std::size_t vertex = index(draw, i);
        std::array<float, 4> value{0, 0, 0, 1};
        const std::size_t at = draw.vertex_address + 4 * (vertex * format.stride + element.offset);
        std::memcpy(value.data(), device.memory.data() + at, 4u * element.components);
        return value;
    }
    std::array<float, 4> position(const DrawCommand& draw, std::uint32_t i) const {
        return attribute(draw, i, Attribute::Position);
    }

    // The x coordinates of a draw's vertices, which serve as their names.
    std::vector<float> names(const DrawCommand& draw) const {
        std::vector<float> all;
        for (std::uint32_t i = 0; i < draw.count; ++i)
            all.push_back(position(draw, i)[0]);
        return all;
    }

    GLenum error() { return entry::GetError(); }

private:
    std::size_t index(const DrawCommand& draw, std::uint32_t i) const {
        if (draw.index_type == IndexType::None) return draw.first + i;
        const std::size_t bytes = draw.index_type == IndexType::U16 ? 2 : 4;
        std::uint32_t value = 0;
        std::memcpy(
            &value, device.memory.data() + draw.index_address + (draw.first + i) * bytes, bytes);
        return value;
    }
};

} // namespace ffgpu::gl
