// What the geometry tests share: memory with vertices in it, a draw's state, and a sink that
// keeps copies of what it is given.

#pragma once

#include "model/geometry/geometry_unit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <random>
#include <span>
#include <vector>

namespace ffgpu {

struct KeptPrimitive {
    Primitive primitive;
    std::array<WindowVertex, 3> vertices;

    const WindowVertex& operator[](unsigned i) const { return vertices[i]; }
};

class KeepingSink final : public PrimitiveSink {
public:
    void primitives(std::span<const Primitive> batch) override {
        ++calls;
        for (const Primitive& primitive : batch) {
            KeptPrimitive copy{primitive, {}};
            for (unsigned i = 0; i < 3; ++i)
                if (primitive.vertices[i]) copy.vertices[i] = *primitive.vertices[i];
            kept.push_back(copy);
        }
    }

    std::vector<KeptPrimitive> kept;
    unsigned calls = 0;
};

// A draw with its memory. Vertices are position (4), then colour (4) where it has one, and so on:
// `words` is filled by the test.
struct Scene {
    Scene() {
        registers.viewport = {.x = 0, .y = 0, .width = 256, .height = 256};
        registers.scissor = {.x = 0, .y = 0, .width = 256, .height = 256};
        layout.color = 0;
        layout.count = 4;
    }

    // Adds an attribute to the vertex format.
    void carry(Attribute attribute, unsigned components) {
        auto& format = registers.vertex_format;
        format.elements[static_cast<unsigned>(attribute)] = {static_cast<std::uint8_t>(components),
                                                             format.stride};
        format.stride = static_cast<std::uint8_t>(format.stride + components);
    }
    void carry_color() { carry(Attribute::Color, 4); }

    void vertex(std::initializer_list<float> values) {
        words.insert(words.end(), values.begin(), values.end());
    }

    std::uint32_t vertex_count() const {
        return static_cast<std::uint32_t>(words.size() / registers.vertex_format.stride);
    }

    DrawCommand command(PrimitiveType type) const {
        DrawCommand command;
        command.primitive = type;
        command.vertex_count = vertex_count();
        command.count =
            indices.empty() ? command.vertex_count : static_cast<std::uint32_t>(indices.size());
        if (!indices.empty()) {
            command.index_type = IndexType::U32;
            command.index_address = static_cast<DeviceAddress>(words.size() * 4);
        }
        return command;
    }

    DrawState state() const {
        DrawState state;
        state.registers = std::make_shared<const Registers>(registers);
        state.layout = layout;
        return state;
    }

    // `spare`: bytes behind the vertices and indices.
    void fill_memory(std::size_t spare = 0) {
        memory.assign((words.size() + indices.size()) * 4 + spare, std::byte{});
        if (!words.empty()) std::memcpy(memory.data(), words.data(), words.size() * 4);
        if (!indices.empty())
            std::memcpy(memory.data() + words.size() * 4, indices.data(), indices.size() * 4);
    }

    std::vector<KeptPrimitive> draw(const DrawCommand& draw_command) {
        fill_memory();
        GeometryUnit unit(memory);
        KeepingSink sink;
        work = {};
        unit.draw(state(), draw_command, sink, &work);
        return sink.kept;
    }
    std::vector<KeptPrimitive> draw(PrimitiveType type) { return draw(command(type)); }

    Registers registers;
    InterpolantLayout layout;
    std::vector<float> words;
    std::vector<std::uint32_t> indices;
    std::vector<std::byte> memory;
    GeometryWork work;
};

inline std::size_t count_fate(const GeometryWork& work, PrimitiveFate fate) {
    return static_cast<std::size_t>(
        std::count_if(work.primitives.begin(), work.primitives.end(), [&](const PrimitiveWork& p) {
            return p.fate == fate;
        }));
}

// Cut by a plane, with something left.
inline std::size_t count_clipped(const GeometryWork& work) {
    return static_cast<std::size_t>(
        std::count_if(work.primitives.begin(), work.primitives.end(), [](const PrimitiveWork& p) {
            return p.planes > 0 && p.fate != PrimitiveFate::Outside;
        }));
}

// Uniform in [low, high), from raw draws of the generator.
class Random {
public:
    explicit Random(std::uint32_t seed)
        : generator_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(generator_()); }
    std::uint32_t below(std::uint32_t limit) { return bits() % limit; }
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits() >> 8) * 0x1p-24f);
    }

private:
    std::mt19937 generator_;
};

} // namespace ffgpu
