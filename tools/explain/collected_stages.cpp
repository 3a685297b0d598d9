// HistoryCollector: what each stage tells of the watched fragments.

#include "tools/explain/history_collector.h"

namespace ffgpu::tools {
namespace {

Rgba color_at(const ColorPlanes& planes, unsigned lane) {
    const auto byte = [lane](const auto& plane) { return static_cast<std::uint8_t>(plane[lane]); };
    return {byte(planes.r), byte(planes.g), byte(planes.b), byte(planes.a)};
}

ColorChange change(const ColorPlanes& before, const probed::Batch& batch, unsigned lane) {
    return {color_at(before, lane), color_at(batch.fragments->color, lane)};
}

// The unit's note, whose coordinates were told before; of an image they are constant and were not.
TextureNote& texture_of(FragmentNote& note, unsigned unit) {
    for (TextureNote& texture : note.textures)
        if (texture.unit == unit) return texture;
    return note.textures.emplace_back(TextureNote{.unit = unit});
}

void note_sampling(const probed::Sampling& told, unsigned lane, TextureNote& texture) {
    for (const probed::QuadLevels& quad : told.quads)
        if (quad.quad == lane / 4) texture.quad = quad;
    for (const probed::Probe& probe : told.probes) {
        if (probe.lane != lane) continue;
        const auto filters = told.level_filters.subspan(probe.level_filter, probe.level_filters);
        texture.probes.push_back({probe, {filters.begin(), filters.end()}});
    }
    const TexCoordPlanes& at = *told.coordinates;
    texture.coordinates = {at.s[lane], at.t[lane], at.r[lane]};
    texture.color = color_at(*told.result, lane);
}

} // namespace

void HistoryCollector::depth(const probed::Batch& batch) {
    const FragmentBatch& fragments = *batch.fragments;
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        if (!fragments.sample_depths) {
            note.depth = fragments.depth[lane];
            return;
        }
        for (unsigned i = 0; i < note.state->samples; ++i)
            note.sample_depths.push_back(fragments.sample_depths->of[i][lane]);
    });
}

void HistoryCollector::perspective(const probed::Batch& batch, const probed::Perspective& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.inverse_w = told.inverse_w[lane];
        note.w = told.w[lane];
    });
}

void HistoryCollector::colors(const probed::Batch& batch, const probed::Colors& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.has_colors = true;
        for (unsigned i = 0; i < 4; ++i) {
            note.primary_over_w[i] = told.primary_over_w[i][lane];
            note.secondary_over_w[i] = told.secondary_over_w[i][lane];
        }
        note.fog_over_w = told.fog_over_w[lane];
        note.primary = color_at(batch.fragments->primary, lane);
        note.secondary = color_at(batch.fragments->secondary, lane);
        note.fog_coordinate = batch.fragments->fog_coordinate[lane];
    });
}

void HistoryCollector::tex_coords(const probed::Batch& batch, const probed::TexCoords& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        TextureNote& texture = texture_of(note, told.unit);
        texture.carried = told.carried;
        for (unsigned i = 0; i < told.carried; ++i)
            texture.over_w[i] = told.over_w[i][lane];
    });
}

void HistoryCollector::sampling(const probed::Batch& batch, const probed::Sampling& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note_sampling(told, lane, texture_of(note, told.unit));
    });
}

void HistoryCollector::environment(const probed::Batch& batch, const probed::Environment& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.environments.push_back(
            {told.unit, color_at(*told.previous, lane), color_at(batch.fragments->color, lane)});
    });
}

void HistoryCollector::color_sum(const probed::Batch& batch, const ColorPlanes& before) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.color_sum = change(before, batch, lane);
    });
}

void HistoryCollector::fog(const probed::Batch& batch, const probed::Fog& told) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.fog = change(*told.before, batch, lane);
        note.fog_factor = told.factor[lane];
    });
}

void HistoryCollector::antialias(const probed::Batch& batch, const ColorPlanes& before) {
    for_live(batch, [&](unsigned lane, FragmentNote& note) {
        note.antialias = change(before, batch, lane);
        note.coverage = batch.fragments->antialias[lane];
    });
}

void HistoryCollector::sample_mask(const probed::Batch& batch, const SampleMasks& before) {
    const FragmentMask covered = any_sample(before);
    for_lanes(covered, [&](unsigned lane, FragmentNote& note) {
        std::array<unsigned, 2> bits{};
        for (unsigned i = 0; i < MaxSamples; ++i) {
            bits[0] |= unsigned{before[i].test(lane)} << i;
            bits[1] |= unsigned{batch.fragments->samples[i].test(lane)} << i;
        }
        note.sample_mask = bits;
    });
}

void HistoryCollector::alpha_test(const probed::Batch& batch, const probed::Test& told) {
    if (!told.on) return;
    for_lanes(told.before, [&](unsigned lane, FragmentNote& note) {
        note.alpha_passed = told.after.test(lane);
        note.alpha = static_cast<std::uint8_t>(batch.fragments->color.a[lane]);
    });
}

void HistoryCollector::stencil_depth(const probed::Batch& batch, const probed::StencilDepth& told) {
    if (!told.on) return;
    for_lanes(told.before, [&](unsigned lane, FragmentNote& note) {
        note.visits.push_back({.sample = told.sample,
                               .early = told.early,
                               .passed_stencil = told.after_stencil.test(lane),
                               .passed_depth = told.after_depth.test(lane),
                               .depth = batch.fragments->depth[lane],
                               .stored_depth = told.stored_depth[lane],
                               .new_depth = told.new_depth[lane],
                               .stored_stencil = told.stored_stencil[lane],
                               .new_stencil = told.new_stencil[lane]});
    });
}

void HistoryCollector::color_write(const probed::Batch& batch, const probed::ColorWrite& told) {
    for_lanes(told.written, [&](unsigned lane, FragmentNote& note) {
        note.writes.push_back({told.target,
                               told.sample,
                               color_at(batch.fragments->color, lane),
                               told.destination[lane],
                               told.blended[lane],
                               told.stored[lane]});
    });
}

} // namespace ffgpu::tools
