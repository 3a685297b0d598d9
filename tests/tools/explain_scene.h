// Frames made by hand on a tape, and the histories of their pixels.

#pragma once

#include "tests/gpu/scene.h"
#include "tools/explain/explain_frame.h"

#include <vector>

namespace ffgpu::tools {

// A 16x16 picture with depth and stencil. Pixels count from the upper left, as pictures do.
class ExplainScene {
public:
    static constexpr std::uint16_t Side = 16;
    static constexpr std::uint32_t Stride = 4 * Side;

    // What `before` draws is no part of the frame.
    explicit ExplainScene(void (*before)(ExplainScene&) = nullptr)
        : gpu_({.memory_bytes = std::uint64_t{32} << 20})
        , tape_(gpu_) {
        registers.targets.color[0] = color;
        registers.targets.depth = depth;
        registers.scissor = {0, 0, Side, Side};
        registers.viewport.width = registers.viewport.height = Side;
        registers.vertex_format.stride = sizeof(test::Vertex) / 4;
        registers.vertex_format.elements[static_cast<unsigned>(Attribute::Color)] = {4, 4};
        registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {2, 8};
        if (before) before(*this);
        tape_.start(7, nullptr);
    }

    template <class Command>
    void command(const Command& what) {
        CommandStream stream;
        write_changes(sent_, registers, stream);
        stream.add(what);
        tape_.submit(stream);
        sent_ = registers;
    }

    void clear(std::uint32_t value) {
        command(ClearCommand{.color = true,
                             .depth = true,
                             .stencil = true,
                             .color_value = value,
                             .depth_value = 0xffffff});
    }

    // A triangle over all of the picture, at one depth (-1 near, 1 far).
    void fill(std::array<float, 4> rgba, float z = 0) {
        const auto vertex = [&](float x, float y) {
            return test::Vertex{
                x, y, z, 1, rgba[0], rgba[1], rgba[2], rgba[3], (x + 1) / 2, (y + 1) / 2};
        };
        draw({vertex(-1, -1), vertex(3, -1), vertex(-1, 3)});
    }

    void draw(const std::vector<test::Vertex>& vertices,
              PrimitiveType type = PrimitiveType::Triangles) {
        upload(next_vertices_, test::bytes_of(vertices));
        const auto count = static_cast<std::uint32_t>(vertices.size());
        command(DrawCommand{.primitive = type,
                            .count = count,
                            .vertex_count = count,
                            .vertex_address = next_vertices_});
        next_vertices_ += 4096;
    }

    void upload(DeviceAddress at, std::span<const std::byte> bytes) {
        tape_.write_memory(at, bytes);
    }

    PixelHistory history(unsigned x, unsigned y) { return histories({{x, y}}).front(); }

    std::vector<PixelHistory> histories(const std::vector<std::pair<unsigned, unsigned>>& pixels) {
        gpu_.finish();
        std::vector<std::uint32_t> values;
        for (const auto& [px, py] : pixels) {
            std::uint32_t word = 0;
            gpu_.read_memory(picture.address + (Side - 1 - py) * Stride + 4 * px,
                             std::as_writable_bytes(std::span(&word, 1)));
            values.push_back(word);
        }
        return explain_frame(
            {.tape = tape_.tape(), .picture = picture, .pixels = pixels, .values = values});
    }

    const FrameTape& tape() const { return tape_.tape(); }

    const Surface color{test::ColorAt, Format::Rgba8, Side, Side, Stride};
    const Surface depth{test::DepthAt, Format::Depth24Stencil8, Side, Side, Stride};
    Surface picture = color;
    Registers registers;

private:
    FunctionalGpu gpu_;
    TapeDevice tape_;
    Registers sent_;
    DeviceAddress next_vertices_ = test::VerticesAt;
};

} // namespace ffgpu::tools
