// Helpers of the GPU's tests: memory laid out by hand, raw commands, pictures read back.

#pragma once

#include "model/gpu/functional_gpu.h"

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ffgpu::test {

constexpr DeviceAddress ColorAt = 0x100000;
constexpr DeviceAddress DepthAt = 0x400000;
constexpr DeviceAddress VerticesAt = 0x800000;
constexpr DeviceAddress TextureAt = 0x1800000;

// Position x y z w, colour r g b a, texture coordinate s t.
struct Vertex {
    float x, y, z, w;
    float r, g, b, a;
    float s, t;
};

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

// A GPU with an RGBA8 and a 24-bit depth target, and registers that are changed at will before a
// draw sends them.
class Scene {
public:
    Scene(int width, int height, FunctionalGpu::Config config = {})
        : gpu([&] {
            if (config.memory_bytes == DeviceMemory::DefaultBytes)
                config.memory_bytes = std::uint64_t{32} << 20; // enough for what is above
            return config;
        }())
        , width_(width)
        , height_(height) {
        const auto w = static_cast<std::uint16_t>(width), h = static_cast<std::uint16_t>(height);
        const auto stride = static_cast<std::uint32_t>(4 * width);
        registers.targets.color[0] = {ColorAt, Format::Rgba8, w, h, stride};
        registers.targets.depth = {DepthAt, Format::Depth24Stencil8, w, h, stride};
        registers.scissor = {0, 0, w, h};
        registers.viewport.width = static_cast<float>(width);
        registers.viewport.height = static_cast<float>(height);
        registers.vertex_format.stride = sizeof(Vertex) / 4;
        registers.vertex_format.elements[static_cast<unsigned>(Attribute::Color)] = {4, 4};
        registers.vertex_format.elements[static_cast<unsigned>(Attribute::TexCoord0)] = {2, 8};
    }

    void send() {
        CommandStream stream;
        write_changes(sent_, registers, stream);
        into->submit(stream);
        sent_ = registers;
    }

    template <class Command>
    void command(const Command& what) {
        send();
        CommandStream stream;
        stream.add(what);
        into->submit(stream);
    }

    void clear(std::uint32_t color) {
        ClearCommand clear;
        clear.color = clear.depth = clear.stencil = true;
        clear.color_value = color;
        clear.depth_value = 0xffffff;
        command(clear);
    }

    void draw(PrimitiveType type, const std::vector<Vertex>& vertices) {
        // Each draw has memory of its own, so that draws stay together in a bin.
        into->write_memory(next_vertices_, bytes_of(vertices));
        DrawCommand draw;
        draw.primitive = type;
        draw.count = draw.vertex_count = static_cast<std::uint32_t>(vertices.size());
        draw.vertex_address = next_vertices_;
        next_vertices_ += static_cast<DeviceAddress>(vertices.size() * sizeof(Vertex));
        if (next_vertices_ > TextureAt - 0x100000) next_vertices_ = VerticesAt;
        command(draw);
    }

    // Colour of a pixel, red in the lowest byte.
    std::vector<std::uint32_t> picture() { return read(ColorAt); }
    std::vector<std::uint32_t> depth_buffer() { return read(DepthAt); }
    // How many different ones there are.
    std::size_t colors() {
        const std::vector<std::uint32_t> all = picture();
        return std::set(all.begin(), all.end()).size();
    }
    std::uint32_t pixel(int x, int y) {
        return picture()[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(x)];
    }

    // A square RGBA8 texture on unit 0, nearest, replacing the colour.
    void texture(std::uint32_t size, const std::vector<std::uint32_t>& texels) {
        into->write_memory(TextureAt, bytes_of(texels));
        registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, size, size, 1, 1, 0};
        registers.images[0].address = TextureAt;
        registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = false;
        registers.samplers[0].mip_filter = MipFilter::None;
        registers.combiners[0].enable = true;
        registers.combiners[0].rgb.arguments[0] = {CombineSource::Texture0, CombineOperand::Color};
        registers.combiners[0].alpha.arguments[0] = {CombineSource::Texture0,
                                                     CombineOperand::Alpha};
    }

    Registers registers;
    FunctionalGpu gpu;
    Device* into = &gpu; // what is told all: one that passes it on to the GPU as well

private:
    std::vector<std::uint32_t> read(DeviceAddress at) {
        std::vector<std::uint32_t> words(static_cast<std::size_t>(width_) *
                                         static_cast<std::size_t>(height_));
        gpu.read_memory(at, std::as_writable_bytes(std::span(words)));
        return words;
    }

    int width_, height_;
    Registers sent_;
    DeviceAddress next_vertices_ = VerticesAt;
};

inline std::uint64_t hash(const std::vector<std::uint32_t>& words) {
    std::uint64_t value = 0xcbf29ce484222325; // FNV-1a
    for (const std::uint32_t word : words)
        value = (value ^ word) * 0x100000001b3;
    return value;
}

// What the GPU counted, by name.
inline std::map<std::string, std::uint64_t> counters(const FunctionalGpu& gpu) {
    std::map<std::string, std::uint64_t> all;
    for (const StatisticsGroup* group : gpu.statistics())
        for (const Counter& counter : group->counters())
            all[std::string(counter.name())] = counter.value();
    return all;
}

} // namespace ffgpu::test
