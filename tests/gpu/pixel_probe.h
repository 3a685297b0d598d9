// A stage probe that keeps what it is told of one pixel's fragment.

#pragma once

#include "model/packets/stage_probe.h"
#include "model/raster/setup_record.h"

#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::test {

using Color = probed::Rgba;

inline Color color_at(const ColorPlanes& planes, unsigned lane) {
    const auto byte = [](std::uint16_t value) { return static_cast<std::uint8_t>(value); };
    return {byte(planes.r[lane]), byte(planes.g[lane]), byte(planes.b[lane]), byte(planes.a[lane])};
}

inline Color unpacked(std::uint32_t word) {
    const auto byte = [&](unsigned i) { return static_cast<std::uint8_t>(word >> (8 * i)); };
    return {byte(0), byte(1), byte(2), byte(3)};
}

// The fragment of one pixel, where it is live; the last one wins.
struct PixelProbe : StageProbe {
    unsigned x, y;
    std::vector<std::string> order; // the stages as they came

    explicit PixelProbe(unsigned at_x, unsigned at_y)
        : x(at_x)
        , y(at_y) {}

    std::optional<unsigned> lane_of(const probed::Batch& batch) const {
        for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane) {
            const FragmentBatch& fragments = *batch.fragments;
            const bool is_it = fragments.x[lane / 4] + (lane & 1) == x &&
                               fragments.y[lane / 4] + (lane >> 1 & 1) == y;
            if (is_it && seen_live.test(lane)) return lane;
        }
        return std::nullopt;
    }

    unsigned records = 0, empty = 0;
    void set_up(const probed::SetUp& told) override {
        told.record ? ++records : ++empty;
        REQUIRE(told.registers != nullptr);
        first_vertex = *told.primitive->vertices[0];
    }
    void coverage(const probed::Batch& batch, const probed::Coverage& told) override {
        seen_live = batch.fragments->live;
        for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane) {
            bool inside = true;
            for (const auto& edge : told.edges)
                inside = inside && edge[lane] >= 0;
            inside_disagrees += inside != seen_live.test(lane);
        }
        take(batch, "coverage", [&](unsigned lane) {
            key = probed::key_of(batch, lane);
            for (unsigned i = 0; i < edges.size(); ++i)
                edges[i] = told.edges[i][lane];
            const unsigned run = batch.runs.size() > 1 && lane >= 4 * batch.runs[1].first_quad;
            record_key = batch.runs[run].record->key;
        });
    }
    void depth(const probed::Batch& batch) override {
        take(batch, "depth", [&](unsigned lane) { depth_value = batch.fragments->depth[lane]; });
    }
    void perspective(const probed::Batch& batch, const probed::Perspective& told) override {
        take(batch, "perspective", [&](unsigned lane) {
            inverse_w = told.inverse_w[lane];
            w = told.w[lane];
            inverse_w_left = told.inverse_w[lane - 1]; // x is odd: the lane to the left
        });
    }
    void colors(const probed::Batch& batch, const probed::Colors& told) override {
        take(batch, "colors", [&](unsigned lane) {
            primary = color_at(batch.fragments->primary, lane);
            secondary = color_at(batch.fragments->secondary, lane);
            fog_coordinate = batch.fragments->fog_coordinate[lane];
            fog_over_w = told.fog_over_w[lane];
            frame = batch.frame;
            for (unsigned i = 0; i < 4; ++i) {
                primary_over_w[i] = told.primary_over_w[i][lane];
                secondary_over_w[i] = told.secondary_over_w[i][lane];
            }
        });
    }
    void tex_coords(const probed::Batch& batch, const probed::TexCoords& told) override {
        take(batch, "tex_coords", [&](unsigned lane) {
            s_over_w = told.over_w[0][lane];
            carried = told.carried;
            for (unsigned i = 0; i < carried; ++i)
                tex_coord_over_w[i] = told.over_w[i][lane];
            s = told.result->s[lane];
            t = told.result->t[lane];
        });
    }
    void sampling(const probed::Batch& batch, const probed::Sampling& told) override {
        take(batch, "sampling", [&](unsigned lane) {
            for (const probed::QuadLevels& quad : told.quads)
                if (quad.quad == lane / 4) levels = quad;
            for (const probed::Probe& one : told.probes)
                if (one.lane == lane) {
                    probe = one;
                    filter = told.level_filters[one.level_filter];
                }
            sampled = color_at(*told.result, lane);
        });
    }
    void environment(const probed::Batch& batch, const probed::Environment& told) override {
        take(batch, "environment", [&](unsigned lane) {
            previous = color_at(*told.previous, lane);
            combined = color_at(batch.fragments->color, lane);
        });
    }
    void color_sum(const probed::Batch& batch, const ColorPlanes& before) override {
        take(batch, "color_sum", [&](unsigned lane) {
            CHECK(color_at(before, lane) == combined);
            summed = color_at(batch.fragments->color, lane);
        });
    }
    void fog(const probed::Batch& batch, const probed::Fog& told) override {
        take(batch, "fog", [&](unsigned lane) {
            CHECK(color_at(*told.before, lane) == summed);
            fog_factor = told.factor[lane];
            fogged = color_at(batch.fragments->color, lane);
        });
    }
    void antialias(const probed::Batch& batch, const ColorPlanes& before) override {
        take(batch, "antialias", [&](unsigned lane) {
            covered = batch.fragments->antialias[lane];
            alpha_before = color_at(before, lane)[3];
            alpha_after = color_at(batch.fragments->color, lane)[3];
        });
    }
    void sample_mask(const probed::Batch& batch, const SampleMasks& before) override {
        take(batch, "sample_mask", [&](unsigned lane) {
            for (unsigned i = 0; i < MaxSamples; ++i) {
                samples_before |= unsigned{before[i].test(lane)} << i;
                samples_after |= unsigned{batch.fragments->samples[i].test(lane)} << i;
            }
        });
    }
    void alpha_test(const probed::Batch& batch, const probed::Test& told) override {
        if (!told.on) return;
        take(batch, "alpha_test", [&](unsigned lane) {
            before_alpha = told.before.test(lane);
            after_alpha = told.after.test(lane);
        });
    }
    void stencil_depth(const probed::Batch& batch, const probed::StencilDepth& told) override {
        if (!told.on) return;
        take(batch, "stencil_depth", [&](unsigned lane) {
            early = told.early;
            passed_stencil = told.after_stencil.test(lane);
            passed_depth = told.after_depth.test(lane);
            stored_depth = told.stored_depth[lane];
            new_depth = told.new_depth[lane];
            stored_stencil = told.stored_stencil[lane];
            new_stencil = told.new_stencil[lane];
        });
    }
    void color_write(const probed::Batch& batch, const probed::ColorWrite& told) override {
        take(batch, "color_write", [&](unsigned lane) {
            if (!told.written.test(lane)) return;
            ++writes;
            source = color_at(batch.fragments->color, lane);
            destination = unpacked(told.destination[lane]);
            blended = unpacked(told.blended[lane]);
            stored = unpacked(told.stored[lane]);
        });
    }

    FragmentMask seen_live; // behind coverage
    unsigned inside_disagrees = 0;
    WindowVertex first_vertex;
    FragmentKey key{};
    std::uint32_t record_key = ~0u, depth_value = 0, stored_depth = 0, new_depth = 0;
    std::array<std::int64_t, 4> edges{};
    std::array<double, 4> primary_over_w{}, secondary_over_w{}, tex_coord_over_w{};
    unsigned frame = ~0u, carried = 0;
    double inverse_w = 0, inverse_w_left = 0, fog_over_w = 0, s_over_w = 0;
    float w = 0, fog_coordinate = 0, s = 0, t = 0;
    Color primary{}, secondary{}, sampled{}, previous{}, combined{}, summed{}, fogged{}, source{},
        destination{}, blended{}, stored{};
    probed::QuadLevels levels;
    probed::Probe probe;
    probed::LevelFilter filter;
    unsigned fog_factor = 0, covered = 0, alpha_before = 0, alpha_after = 0, stored_stencil = 0,
             new_stencil = 0, samples_before = 0, samples_after = 0, writes = 0;
    bool before_alpha = false, after_alpha = false, early = false, passed_stencil = false,
         passed_depth = false;

private:
    template <class Read>
    void take(const probed::Batch& batch, const char* stage, Read&& read) {
        const std::optional<unsigned> lane = lane_of(batch);
        if (!lane) return;
        order.emplace_back(stage);
        read(*lane);
    }
};

} // namespace ffgpu::test
