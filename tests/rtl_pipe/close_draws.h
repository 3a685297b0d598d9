// Draws for the fragment pipe in RTL: triangles, textures and states at random, each compared with
// the model's, or behind each other without a gap.

#pragma once

#include "tests/gpu/scene.h"
#include "tests/rtl_pipe/random_draws.h"
#include "tools/rtl/pipe_comparison.h"

#include <algorithm>
#include <cstring>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {

constexpr rtl::PipeOptions memory(unsigned latency, unsigned stall_percent, std::uint64_t seed) {
    return {
        .latency = latency, .stall_percent = stall_percent, .seed = seed, .quiet_cycles = 1 << 14};
}

inline const std::array Memories{memory(1, 0, 1), memory(20, 25, 2), memory(90, 60, 3)};

inline std::vector<test::Vertex> triangles(test::RandomStates& random, unsigned count) {
    const auto unit = [&] { return static_cast<float>(random.below(65536)) / 32768.0f - 1.0f; };
    const float size = random.chance(3) ? 1.5f : 0.3f;
    const bool flat = random.chance(3);
    std::vector<test::Vertex> vertices;
    for (unsigned i = 0; i < count; ++i) {
        const float x = unit(), y = unit();
        for (int corner = 0; corner < 3; ++corner) {
            const float w = flat ? 1.0f : 1.5f + unit();
            vertices.push_back({(x + size * unit()) * w,
                                (y + size * unit()) * w,
                                unit() * w * 0.7f,
                                w,
                                unit(),
                                unit(),
                                unit(),
                                unit(),
                                unit() * 4,
                                unit() * 4});
        }
    }
    return vertices;
}

// Noise under the textures; coordinates for all units, those of four words divided by q.
inline void prepare(test::Scene& scene) {
    std::mt19937 random(5);
    std::vector<std::uint32_t> noise(0x40000);
    std::ranges::generate(noise, random);
    scene.into->write_memory(test::TextureAt, std::as_bytes(std::span(noise)));
    auto& elements = scene.registers.vertex_format.elements;
    constexpr std::array<VertexElement, TextureUnits> Coordinates{
        {{2, 8}, {4, 6}, {3, 7}, {4, 4}, {2, 6}, {4, 5}, {3, 5}, {4, 6}}};
    std::ranges::copy(Coordinates, &elements[static_cast<unsigned>(Attribute::TexCoord0)]);
    elements[static_cast<unsigned>(Attribute::SecondaryColor)] = {3, 5};
    elements[static_cast<unsigned>(Attribute::FogCoordinate)] = {1, 8};
    scene.clear(0x80402010);
}

// Rows of an odd number of pairs: in small formats the two of a quad begin at different bytes.
inline void space_rows(Surface& surface) {
    surface.stride = format_info(surface.format).block_bytes * (surface.width + 2u);
}

// Up to three in most draws, up to all in some.
inline unsigned textured_units(test::RandomStates& random) {
    return random.chance(4) ? random.below(TextureUnits + 1) : random.below(4);
}

inline std::string told(const PipeComparison& comparison, unsigned draw) {
    return fmt::format("draw {}\n{}", draw, comparison.summary());
}

// Draws for a pipe without a gap between them, and the model's.
class CloseDraws {
public:
    explicit CloseDraws(const rtl::PipeOptions& options)
        : pipe_(open_rtl_pipe(options)) {
        targets_.fill(model_.registers.targets);
        targets_[1].color[0] = beside(targets_[1].color[0], Format::Rgb565);
        targets_[1].depth = beside(targets_[1].depth, Format::Depth16);
        targets_[2].depth.format = Format::None; // Its quads wait for no pixels between others.
        for (test::Scene* scene : {&model_, &drawn_})
            for (const Targets& targets : targets_) {
                scene->registers.targets = targets;
                prepare(*scene);
            }
        drawn_.gpu.settled_memory(); // The clear is in it.
        pipe_->set_memory(bytes_);
    }

    rtl::Pipe& pipe() { return *pipe_; }

    // The pipe's part of one may be given up after some records.
    void draw(std::size_t most_records = SIZE_MAX) {
        draw_textured(textured_units(random_), most_records);
    }
    void draw_textured(unsigned units, std::size_t most_records = SIZE_MAX) {
        vary(units);
        draw_as_set(triangles(random_, 1 + random_.below(3)), most_records);
    }
    // The registers of the next draw.
    Registers& vary(unsigned units) {
        random_.vary(model_.registers, units);
        model_.registers.targets = targets_[random_.below(3)];
        return model_.registers;
    }
    void draw_as_set(const std::vector<test::Vertex>& vertices,
                     std::size_t most_records = SIZE_MAX) {
        model_.draw(PrimitiveType::Triangles, vertices);
        // Behind everything that a draw reads.
        constexpr DeviceAddress At = test::VerticesAt;
        const std::size_t size = vertices.size() * sizeof vertices[0];
        if (size > 0) std::memcpy(bytes_.data() + At, vertices.data(), size);
        DrawCommand command;
        command.primitive = PrimitiveType::Triangles;
        command.count = command.vertex_count = static_cast<std::uint32_t>(vertices.size());
        command.vertex_address = At;
        records_.make(model_.registers, number_, command);
        pipe_->begin_draw(records_.context(), number_++);
        std::size_t added = 0;
        records_.for_each([&](const SetupRecord& record) {
            if (added++ < most_records) pipe_->add(record);
        });
    }

    // Draws are numbered anew, too: nothing may be known by a number of before.
    void reset() {
        pipe_->reset();
        number_ = 0;
    }

    // What the pipe draws on becomes what the model has.
    void equalize() { std::ranges::copy(model_.gpu.settled_memory(), bytes_.begin()); }

    TargetDifference difference() {
        REQUIRE(pipe_->finish());
        TargetDifference found;
        for (const Targets& targets : targets_)
            if (found.target.empty())
                found = TargetComparison().compare(targets, model_.gpu, drawn_.gpu);
        return found;
    }

private:
    // Another target behind this one, in another format.
    static Surface beside(Surface surface, Format format) {
        surface.address += 0x100000;
        surface.format = format;
        space_rows(surface);
        return surface;
    }

    std::unique_ptr<rtl::Pipe> pipe_;
    test::Scene model_{40, 36}, drawn_{40, 36};
    std::array<Targets, 3> targets_;
    std::span<std::byte> bytes_ = drawn_.gpu.settled_memory();
    PipeRecords records_{bytes_};
    test::RandomStates random_{11};
    std::uint32_t number_ = 0;
};

} // namespace ffgpu::tools
