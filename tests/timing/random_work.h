// Machines and frames drawn by lot, from a seed.

#pragma once

#include "model/timing/config.h"
#include "model/work/whole_command.h"
#include "tests/support/drawn_quad.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class RandomWork {
public:
    explicit RandomWork(std::uint64_t seed)
        : random_(seed) {}

    std::uint32_t below(std::uint32_t limit) {
        return static_cast<std::uint32_t>(random_() % limit);
    }
    // One of 1, 2, 4 ... 2^(steps - 1).
    std::uint32_t power(std::uint32_t steps) { return 1u << below(steps); }

    // Small queues as often as large ones, so that every wait happens.
    TimingConfig machine() {
        TimingConfig config;
        config.command_processor.draw_cycles = 1 + below(20);
        config.command_processor.lines_per_cycle = power(3);
        config.vertex.fetch_queue = power(5);
        config.vertex.reuse_entries = below(20);
        config.vertex.transform_cycles = 1 + below(12);
        config.vertex.light_cycles = 1 + below(8);
        config.vertex.latency = 1 + below(60);
        config.setup.queue = power(6);
        config.setup.triangle_cycles = 1 + below(12);
        config.setup.reject_cycles = 1 + below(3);
        config.raster.quads_per_cycle = power(3);
        config.raster.tile_cycles = below(3);
        config.raster.queue = config.raster.quads_per_cycle * power(5);
        config.fragment.queue = config.raster.quads_per_cycle * power(5);
        config.fragment.pipe_queue = power(5);
        config.fragment.combiner_cycles = 1 + below(4);
        config.fragment.latency = 1 + below(30);
        front_end(config);
        if (below(4) == 0) config.raster.architecture = work::Architecture::TileBased;
        config.texel_cache.bilinear_quads_per_cycle = power(3);
        caches(config);
        textures(config);
        memory(config.memory);
        return config;
    }

    // A few draws with clears, copies and images between them.
    std::vector<std::shared_ptr<const work::WholeCommand>> frame(std::uint32_t commands) {
        std::vector<std::shared_ptr<const work::WholeCommand>> frame;
        while (frame.size() < commands) {
            const auto number = static_cast<std::uint32_t>(frame.size());
            const std::uint32_t lot = below(8);
            frame.push_back(
                std::make_shared<work::WholeCommand>(lot == 0   ? clear(number)
                                                     : lot == 1 ? copy(number)
                                                                : any_draw(number, 1, 200, 600)));
        }
        return frame;
    }

    // Any kind; draws as often as all others.
    std::shared_ptr<const work::WholeCommand> any_command(std::uint32_t number) {
        const std::uint32_t lot = below(6);
        return std::make_shared<work::WholeCommand>(lot == 0   ? clear(number)
                                                    : lot == 1 ? copy(number)
                                                    : lot == 2 ? image(number)
                                                               : any_draw(number, 1, 300, 1000));
    }

    // Of `least` vertices and fewer than `more` further ones, and fewer than so many quads.
    work::WholeCommand any_draw(std::uint32_t number,
                                std::uint32_t least,
                                std::uint32_t more,
                                std::uint32_t quads_below) {
        // One after the other: in a call compilers may draw them in any order.
        const std::uint32_t quads = below(quads_below);
        const std::uint32_t vertices = least + below(more);
        return draw(number, vertices, quads);
    }

    // Triangles of `vertices` vertices, and quads in runs along lines of the screen.
    work::WholeCommand draw(std::uint32_t number, std::uint32_t vertices, std::uint32_t quads) {
        work::WholeCommand command = begin(WorkKind::Draw, number);
        auto state = std::make_shared<Registers>(*command.draw.state);
        state->depth = {.test_enable = below(4) > 0, .write_enable = below(2) > 0};
        state->blend.enable = below(2) > 0;
        const std::uint32_t units = below(3);
        for (std::uint32_t unit = 0; unit < units; ++unit) {
            state->combiners[unit].enable = true;
            state->images[unit].address = (DeviceAddress{3} + unit) << 26;
            state->images[unit].shape = {.kind = TextureKind::TwoD,
                                         .format = below(2) > 0 ? Format::Rgba8 : Format::Dxt1Rgb,
                                         .width = TextureSize,
                                         .height = TextureSize,
                                         .levels = 1};
            command.units.push_back(static_cast<std::uint8_t>(unit));
        }
        command.draw.state = state;
        command.draw.early_depth = below(2) > 0;
        GeometryWork& geometry = command.draw.geometry;
        geometry.vertex_bytes = 16 + 4 * below(12);
        geometry.vertex_address = std::uint64_t{7} << 26;
        geometry.lights = static_cast<std::uint8_t>(below(4));
        geometry.index_address = std::uint64_t{6} << 26;
        geometry.index_bytes = static_cast<std::uint8_t>(2 * below(3));
        geometry.interpolants = static_cast<std::uint8_t>(below(9));
        const std::uint32_t distinct = 1 + below(vertices);
        for (std::uint32_t i = 0; i < vertices; ++i)
            geometry.vertices.push_back(below(3) == 0 ? below(distinct) : i % distinct);
        for (std::uint32_t i = 0; i < (vertices + 2) / 3; ++i)
            geometry.primitives.push_back(
                {.key = i,
                 .last_vertex = std::min(3 * i + 2, vertices - 1),
                 .planes = static_cast<std::uint8_t>(below(4) == 0 ? 1 + below(2) : 0)});
        add_quads(command, quads);
        return command;
    }

private:
    static constexpr std::uint16_t Size = 128, TextureSize = 256;

    void front_end(TimingConfig& config) {
        config.host.bytes_per_cycle = below(3) == 0 ? 0 : power(6);
        config.host.queue = power(5);
        config.vertex.index_cache_lines = below(3);
        config.vertex.index_queue = power(7);
        config.vertex.fetch_bytes_per_cycle = 4 * below(10);
        config.vertex.vertices_per_cycle = power(3);
        config.vertex.reuse_policy = static_cast<ReusePolicy>(below(2));
        config.vertex.units = 1 + below(6);
        config.vertex.order_entries = power(5);
        config.clip.plane_cycles = below(8);
        config.clip.queue = power(5);
        config.setup.units = 1 + below(4);
        config.setup.attribute_cycles = below(3);
        config.raster.traversal = static_cast<Traversal>(below(6));
        config.raster.empty_tile_cycles = below(3);
        config.raster.block_queue = power(6);
        if (below(3) == 0) config.scan_out.refresh_cycles = 500 + below(5000);
        config.scan_out.queue = power(5);
    }

    void caches(TimingConfig& config) {
        for (CachePace* const pace : {static_cast<CachePace*>(&config.texel_cache),
                                      static_cast<CachePace*>(&config.depth_cache),
                                      static_cast<CachePace*>(&config.color_cache)}) {
            pace->lookups_per_cycle = power(3);
            pace->fragment_fifo = 1 + below(64);
            pace->outstanding_lines = power(6);
            pace->miss_queue = power(4);
            pace->request_queue = power(5);
            pace->banks = power(3);
            pace->ports = below(3);
        }
        config.texel_cache.sets = power(6);
        config.depth_cache.sets = power(6);
        config.color_cache.sets = power(6);
    }

    void textures(TimingConfig& config) {
        config.fragment.distribution = static_cast<Distribution>(below(3));
        if (below(4) == 0) config.raster.granularity = work::Granularity::Fragment;
        config.texture = {1 + below(3), static_cast<UnitShare>(below(2)), below(3)};
        config.texel_cache.per_pipe = below(2) > 0;
        config.texel_cache.contents = static_cast<work::TexelContents>(below(2));
        config.texel_cache.decompress_cycles = below(2) * below(30);
        config.texel_cache.replacement = static_cast<work::Replacement>(below(4));
        TexelL2Config& second = config.texel_l2;
        second.enable = below(2) > 0;
        second.sets = power(8);
        second.replacement = static_cast<work::Replacement>(below(4));
        second.queue = power(5);
        second.outstanding_lines = power(5);
        second.latency = 1 + below(20);
        second.bytes_per_cycle = 8 * power(4);
        second.ports = below(3);
    }

    void memory(MemoryConfig& config) {
        config.profile = static_cast<MemoryProfile>(below(4));
        config.apply_profile();
        config.channels = power(3);
        config.bytes_per_cycle = 4 * power(4);
        config.core_clocks = 1 + below(4);
        config.memory_clocks = 1 + below(4);
        config.client_queue = power(5);
        config.queue = power(5);
        config.latency = below(100);
        config.scheduler = static_cast<SchedulerKind>(below(2));
        config.page_policy = static_cast<PagePolicy>(below(4));
    }

    static work::WholeCommand begin(WorkKind kind, std::uint32_t number) {
        auto state = std::make_shared<Registers>();
        state->targets.color[0] = {.address = 1 << 26,
                                   .format = Format::Rgba8,
                                   .width = Size,
                                   .height = Size,
                                   .stride = 4 * Size};
        state->targets.depth = state->targets.color[0];
        state->targets.depth.address = 2 << 26;
        state->targets.depth.format = Format::Depth24Stencil8;
        state->scissor = {0, 0, Size, Size};
        work::WholeCommand command;
        command.draw.kind = kind;
        command.draw.number = number;
        command.draw.state = state;
        return command;
    }

    work::WholeCommand clear(std::uint32_t number) {
        work::WholeCommand command = begin(WorkKind::Clear, number);
        command.draw.clear.color = true;
        command.draw.clear.depth = below(2) > 0;
        return command;
    }

    work::WholeCommand copy(std::uint32_t number) {
        work::WholeCommand command = begin(WorkKind::Copy, number);
        CopyRectangleCommand& copy = command.draw.copy;
        copy.source = command.draw.state->targets.color[0];
        copy.destination = copy.source;
        copy.destination.address = 9 << 26;
        copy.width = static_cast<std::uint16_t>(1 + below(Size));
        copy.height = static_cast<std::uint16_t>(1 + below(Size / 4));
        return command;
    }

    // Pixels of the host's, from device memory.
    work::WholeCommand image(std::uint32_t number) {
        work::WholeCommand command = begin(WorkKind::Image, number);
        command.draw.image = {.address = DeviceAddress{10} << 26,
                              .stride = 4 * Size,
                              .width = 1 + below(Size),
                              .height = 1 + below(Size)};
        for (std::uint32_t y = 0; y < command.draw.image.height; y += 2)
            for (std::uint32_t x = 0; x < command.draw.image.width; x += 2)
                command.quads.push_back(drawn_quad(x, y));
        return command;
    }

    void add_quads(work::WholeCommand& command, std::uint32_t quads) {
        const std::uint32_t run = 1 + below(40);
        const std::size_t keys = command.draw.geometry.primitives.size();
        std::uint16_t x = 0, y = 0, u = 0, v = 0;
        for (std::uint32_t i = 0; i < quads; ++i) {
            if (i % run == 0) {
                x = static_cast<std::uint16_t>(2 * below(Size / 2));
                y = static_cast<std::uint16_t>(2 * below(Size / 2));
                u = static_cast<std::uint16_t>(below(TextureSize));
                v = static_cast<std::uint16_t>(below(TextureSize));
            }
            const auto covered = static_cast<std::uint8_t>(1 + below(15));
            const auto passed = static_cast<std::uint8_t>(below(4) == 0 ? 0 : covered);
            const std::uint8_t early = command.draw.early_depth ? passed : covered;
            command.quads.push_back({.primitive = static_cast<std::uint32_t>(i * keys / quads),
                                     .x = x,
                                     .y = y,
                                     .covered = covered,
                                     .after_early_depth = early,
                                     .after_coverage = early,
                                     .after_alpha = early,
                                     .after_stencil = passed,
                                     .after_depth = passed});
            add_accesses(command, early, u, v);
            add_to_piece(command.draw.geometry, command.quads.back());
            x = static_cast<std::uint16_t>((x + 2) % Size);
            u = static_cast<std::uint16_t>((u + 2) % TextureSize);
        }
        for (PrimitiveWork& primitive : command.draw.geometry.primitives)
            if (primitive.pieces == 0) primitive.fate = PrimitiveFate::Culled;
    }

    // A primitive with quads is one piece, whose box is theirs.
    static void add_to_piece(GeometryWork& geometry, const WorkQuad& quad) {
        PrimitiveWork& primitive = geometry.primitives[quad.primitive];
        const PieceBox box{.x0 = quad.x,
                           .y0 = quad.y,
                           .x1 = static_cast<std::uint16_t>(quad.x + 2),
                           .y1 = static_cast<std::uint16_t>(quad.y + 2)};
        if (std::exchange(primitive.pieces, 1) == 0) return geometry.pieces.push_back(box);
        PieceBox& piece = geometry.pieces.back();
        piece = {.x0 = std::min(piece.x0, box.x0),
                 .y0 = std::min(piece.y0, box.y0),
                 .x1 = std::max(piece.x1, box.x1),
                 .y1 = std::max(piece.y1, box.y1)};
    }

    static void
    add_accesses(work::WholeCommand& command, std::uint8_t live, std::uint16_t u, std::uint16_t v) {
        const auto next = [](std::uint16_t at) {
            return static_cast<std::uint16_t>((at + 1) % TextureSize);
        };
        for (std::size_t unit = 0; unit < command.units.size(); ++unit) {
            for (std::uint16_t lane = 0; lane < 4; ++lane) {
                if ((live >> lane & 1) == 0) continue;
                const auto x = static_cast<std::uint16_t>((u + lane % 2) % TextureSize);
                const auto y = static_cast<std::uint16_t>((v + lane / 2) % TextureSize);
                command.add_access(unit,
                                   {.lane = lane,
                                    .level = 0,
                                    .linear = 3,
                                    .x0 = x,
                                    .x1 = next(x),
                                    .y0 = y,
                                    .y1 = next(y),
                                    .layer0 = 0,
                                    .layer1 = 0});
            }
        }
    }

    std::mt19937_64 random_;
};

} // namespace ffgpu::timing
