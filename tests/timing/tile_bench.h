// Frames of rectangles for machines in time, and which bins they touch, told from coordinates
// alone.

#pragma once

#include "tests/timing/machine_figures.h"

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace ffgpu::timing {

// Half open; a primitive covers all pixels of it.
struct Box {
    unsigned x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

using BinSet = std::set<std::pair<unsigned, unsigned>>; // row, column

inline BinSet bins_of(const Box& box, unsigned size) {
    BinSet bins;
    for (unsigned y = box.y0; y < box.y1; ++y)
        for (unsigned x = box.x0; x < box.x1; ++x)
            bins.insert({y / size, x / size});
    return bins;
}

class TileBench {
public:
    static constexpr DeviceAddress ColorAt = 1 << 26, DepthAt = 1 << 27, ResolvedAt = 1 << 28;
    static constexpr std::uint32_t RegisterWrites = 3, RegisterWords = 5; // before each command

    TileBench(unsigned width, unsigned height, std::uint8_t samples = 1)
        : width_(width)
        , height_(height) {
        state.targets.color[0] = surface(ColorAt, Format::Rgba8, samples);
        state.targets.depth = surface(DepthAt, Format::Depth24Stencil8, samples);
        state.scissor.width = static_cast<std::uint16_t>(width);
        state.scissor.height = static_cast<std::uint16_t>(height);
    }

    // Primitives of one draw; all fragments pass.
    void draw(const std::vector<Box>& boxes) {
        auto command = add(WorkKind::Draw);
        const auto count = static_cast<std::uint32_t>(boxes.size());
        GeometryWork& geometry = command->draw.geometry;
        geometry.vertex_bytes = 16;
        for (std::uint32_t i = 0; i < 3 * count; ++i)
            geometry.vertices.push_back(i);
        for (std::uint32_t i = 0; i < count; ++i) {
            geometry.primitives.push_back({.key = i, .last_vertex = 3 * i + 2, .pieces = 1});
            geometry.pieces.push_back({static_cast<std::uint16_t>(boxes[i].x0),
                                       static_cast<std::uint16_t>(boxes[i].y0),
                                       static_cast<std::uint16_t>(boxes[i].x1),
                                       static_cast<std::uint16_t>(boxes[i].y1)});
        }
        for (std::uint32_t i = 0; i < count; ++i)
            add_quads(i, boxes[i], *command);
        commands.push_back(std::move(command));
    }
    void clear(bool color, bool depth, bool stencil = false) {
        auto command = add(WorkKind::Clear);
        command->draw.clear = {.color = color, .depth = depth, .stencil = stencil};
        commands.push_back(std::move(command));
    }
    // All samples of the colour target to one a pixel.
    void resolve() {
        auto command = add(WorkKind::Copy);
        CopyRectangleCommand& copy = command->draw.copy;
        copy.source = state.targets.color[0];
        copy.destination = surface(ResolvedAt, Format::Rgba8, 1);
        copy.width = static_cast<std::uint16_t>(width_);
        copy.height = static_cast<std::uint16_t>(height_);
        commands.push_back(std::move(command));
    }
    void end_frame() { commands.push_back(nullptr); }

    Figures run(const TimingConfig& config, const Evaluation& evaluation = {}) const {
        GpuTiming timing(config, evaluation);
        std::uint32_t frame = 0;
        for (const auto& command : commands) {
            if (command) {
                timing.command(command);
            } else {
                timing.end_frame(frame++);
            }
        }
        return figures_of(timing);
    }

    // Pixels of the bins that lie on the targets.
    std::uint64_t pixels(const BinSet& bins, unsigned size) const {
        std::uint64_t sum = 0;
        for (const auto& [row, column] : bins)
            sum += std::uint64_t{std::min(size, height_ - row * size)} *
                   std::min(size, width_ - column * size);
        return sum;
    }
    Box all() const { return {0, 0, width_, height_}; }

    Registers state;                                                 // of the next command
    std::vector<std::shared_ptr<const work::WholeCommand>> commands; // null: a frame ends

private:
    Surface surface(DeviceAddress at, Format format, std::uint8_t samples) const {
        return {.address = at,
                .format = format,
                .width = static_cast<std::uint16_t>(width_),
                .height = static_cast<std::uint16_t>(height_),
                .stride = 4 * width_,
                .samples = samples};
    }
    std::shared_ptr<work::WholeCommand> add(WorkKind kind) {
        auto command = std::make_shared<work::WholeCommand>();
        command->draw.kind = kind;
        command->draw.number = number_++;
        command->draw.early_depth = true;
        command->draw.register_writes = RegisterWrites;
        command->draw.register_words = RegisterWords;
        command->draw.state = std::make_shared<const Registers>(state);
        return command;
    }
    static void add_quads(std::uint32_t primitive, const Box& box, work::WholeCommand& command) {
        for (unsigned y = box.y0 & ~1u; y < box.y1; y += 2)
            for (unsigned x = box.x0 & ~1u; x < box.x1; x += 2) {
                unsigned lanes = 0;
                for (unsigned lane = 0; lane < 4; ++lane) {
                    const unsigned px = x + (lane & 1), py = y + (lane >> 1);
                    lanes |= unsigned{px >= box.x0 && px < box.x1 && py >= box.y0 && py < box.y1}
                             << lane;
                }
                const auto mask = static_cast<std::uint8_t>(lanes);
                unsigned samples = 0;
                for (unsigned lane = 0; lane < 4; ++lane)
                    samples |= (lanes >> lane & 1) * 0xfu << 4 * lane;
                command.quads.push_back({.primitive = primitive,
                                         .x = static_cast<std::uint16_t>(x),
                                         .y = static_cast<std::uint16_t>(y),
                                         .covered = mask,
                                         .after_early_depth = mask,
                                         .after_coverage = mask,
                                         .after_alpha = mask,
                                         .after_stencil = mask,
                                         .after_depth = mask,
                                         .samples_covered = static_cast<std::uint16_t>(samples),
                                         .samples_written = static_cast<std::uint16_t>(samples)});
            }
    }

    unsigned width_, height_;
    std::uint32_t number_ = 0;
};

inline TimingConfig tile_based(unsigned bin_size = 32) {
    TimingConfig config;
    config.raster.architecture = Architecture::TileBased;
    config.raster.bin_size = bin_size;
    return config;
}

} // namespace ffgpu::timing
