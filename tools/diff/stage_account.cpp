#include "tools/diff/stage_account.h"

#include "model/device/registers.h"
#include "model/packets/draw_state.h"
#include "model/raster/setup_record.h"

namespace ffgpu::tools {
namespace {

using Stage = AccountStage;

std::uint32_t packed(const probed::Rgba& color) {
    return std::uint32_t{color[0]} | std::uint32_t{color[1]} << 8 | std::uint32_t{color[2]} << 16 |
           std::uint32_t{color[3]} << 24;
}

std::uint32_t packed(const ColorPlanes& planes, unsigned lane) {
    return std::uint32_t{planes.r[lane]} | std::uint32_t{planes.g[lane]} << 8 |
           std::uint32_t{planes.b[lane]} << 16 | std::uint32_t{planes.a[lane]} << 24;
}

// A bit a sample.
unsigned samples_of(const SampleMasks& masks, unsigned lane) {
    unsigned bits = 0;
    for (unsigned i = 0; i < MaxSamples; ++i)
        bits |= unsigned{masks[i].test(lane)} << i;
    return bits;
}

AccountPlace place_of(const probed::Batch& batch, unsigned lane, unsigned sample) {
    const unsigned quad = lane / 4;
    return {.kind = AccountPlace::Kind::Fragment,
            .primitive = batch.fragments->primitive[quad],
            .piece = batch.pieces[quad],
            .x = batch.fragments->x[quad],
            .y = batch.fragments->y[quad],
            .lane = static_cast<std::uint8_t>(lane % 4),
            .sample = static_cast<std::uint8_t>(sample)};
}

} // namespace

template <class Fill>
void StageAccount::entries(AccountPart part,
                           const probed::Batch& batch,
                           const FragmentMask& lanes,
                           Fill fill,
                           unsigned sample) {
    for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane) {
        if (!lanes.test(lane)) continue;
        sink_.begin(part, place_of(batch, lane, sample));
        fill(lane);
        sink_.end();
    }
}

void StageAccount::set_up(const probed::SetUp& told) {
    const Primitive& primitive = *told.primitive;
    sink_.begin({Stage::SetUp},
                {.kind = AccountPlace::Kind::Primitive,
                 .primitive = primitive.key,
                 .piece = told.record ? told.record->piece : 0});
    sink_.integer("front_facing", primitive.front_facing);
    for (int i = 0; i < 3; ++i) {
        const WindowVertex* const vertex = primitive.vertices[static_cast<std::size_t>(i)];
        if (!vertex) continue;
        sink_.integer("vertex_x", vertex->x, i);
        sink_.integer("vertex_y", vertex->y, i);
        sink_.real("vertex_depth", vertex->depth, i);
        sink_.real("vertex_inverse_w", vertex->inverse_w, i);
    }
    if (const SetupRecord* const record = told.record) {
        sink_.integer("box_x", record->box.x0);
        sink_.integer("box_y", record->box.y0);
        sink_.integer("box_width", record->box.width());
        sink_.integer("box_height", record->box.height());
        sink_.integer("depth_origin", record->depth.origin);
        sink_.integer("depth_dx", record->depth.dx);
        sink_.integer("depth_dy", record->depth.dy);
        const unsigned planes = record->plane_count + unsigned{record->perspective};
        for (unsigned i = 0; i < planes; ++i) {
            const AttributePlane plane = record->plane(i);
            sink_.integer("plane_origin", plane.c, static_cast<int>(i));
            sink_.integer("plane_dx", plane.dx, static_cast<int>(i));
            sink_.integer("plane_dy", plane.dy, static_cast<int>(i));
        }
    }
    sink_.end();
}

void StageAccount::coverage(const probed::Batch& batch, const probed::Coverage& told) {
    const FragmentBatch& fragments = *batch.fragments;
    entries({Stage::Coverage}, batch, fragments.live, [&](unsigned lane) {
        for (std::size_t i = 0; i < told.edges.size(); ++i)
            sink_.integer("edge", told.edges[i][lane], static_cast<int>(i));
        const bool has_samples = batch.registers->targets.samples() > 1;
        if (has_samples) sink_.integer("samples", samples_of(fragments.samples, lane));
    });
}

void StageAccount::depth(const probed::Batch& batch) {
    const FragmentBatch& fragments = *batch.fragments;
    entries({Stage::Depth}, batch, fragments.live, [&](unsigned lane) {
        if (!fragments.sample_depths) return sink_.integer("depth", fragments.depth[lane]);
        for (unsigned i = 0; i < MaxSamples; ++i)
            if (fragments.samples[i].test(lane))
                sink_.integer(
                    "sample_depth", fragments.sample_depths->of[i][lane], static_cast<int>(i));
    });
}

void StageAccount::perspective(const probed::Batch& batch, const probed::Perspective& told) {
    entries({Stage::Perspective}, batch, batch.fragments->live, [&](unsigned lane) {
        sink_.real("inverse_w", told.inverse_w[lane]);
        sink_.real("w", told.w[lane]);
    });
}

void StageAccount::colors(const probed::Batch& batch, const probed::Colors& told) {
    if (!uses_color(*batch.registers)) return;
    const FragmentBatch& fragments = *batch.fragments;
    const bool has_secondary = batch.registers->fragment.color_sum; // else nobody makes one
    entries({Stage::Colors}, batch, fragments.live, [&](unsigned lane) {
        for (std::size_t i = 0; i < 4; ++i) {
            sink_.real("primary_over_w", told.primary_over_w[i][lane], static_cast<int>(i));
            if (has_secondary)
                sink_.real("secondary_over_w", told.secondary_over_w[i][lane], static_cast<int>(i));
        }
        sink_.color("primary", packed(fragments.primary, lane));
        if (has_secondary) sink_.color("secondary", packed(fragments.secondary, lane));
        if (batch.registers->fog.mode == FogMode::Off) return; // Nobody makes one.
        sink_.real("fog_over_w", told.fog_over_w[lane]);
        sink_.real("fog_coordinate", fragments.fog_coordinate[lane]);
    });
}

void StageAccount::tex_coords(const probed::Batch& batch, const probed::TexCoords& told) {
    entries({Stage::TexCoords, told.unit}, batch, batch.fragments->live, [&](unsigned lane) {
        for (unsigned i = 0; i < told.carried; ++i)
            sink_.real("over_w", told.over_w[i][lane], static_cast<int>(i));
        sink_.real("s", told.result->s[lane]);
        sink_.real("t", told.result->t[lane]);
        if (told.carried > 2) sink_.real("r", told.result->r[lane]);
    });
}

void StageAccount::quad_levels(const probed::QuadLevels& quad) {
    for (std::size_t i = 0; i < quad.step_x.size(); ++i) {
        sink_.real("step_x", quad.step_x[i], static_cast<int>(i));
        sink_.real("step_y", quad.step_y[i], static_cast<int>(i));
    }
    sink_.real("footprint_x", quad.footprint_x);
    sink_.real("footprint_y", quad.footprint_y);
    sink_.integer("lambda", quad.lambda);
    sink_.integer("probes", quad.probes);
    sink_.integer("level", quad.level);
    sink_.integer("next_level", quad.next_level);
    sink_.integer("level_weight", quad.weight);
}

void StageAccount::level_filter(const probed::LevelFilter& filter, int index) {
    const TexelAccess& access = filter.access;
    sink_.integer("filter_level", access.level, index);
    sink_.integer("x0", access.x0, index);
    sink_.integer("x1", access.x1, index);
    sink_.integer("y0", access.y0, index);
    sink_.integer("y1", access.y1, index);
    sink_.integer("layer0", access.layer0, index);
    sink_.integer("layer1", access.layer1, index);
    for (std::size_t i = 0; i < filter.weight.size(); ++i)
        sink_.integer("weight", filter.weight[i], index * 4 + static_cast<int>(i));
    for (unsigned i = 0; i < filter.texel_count; ++i)
        sink_.color("texel", packed(filter.texels[i].color), index * 8 + static_cast<int>(i));
    sink_.color("filtered", packed(filter.color), index);
}

// Levels and probes stand by quad and by lane, in order.
void StageAccount::sampling(const probed::Batch& batch, const probed::Sampling& told) {
    auto quad = told.quads.begin();
    auto probe = told.probes.begin();
    entries({Stage::Texture, told.unit}, batch, batch.fragments->live, [&](unsigned lane) {
        while (quad != told.quads.end() && quad->quad < lane / 4)
            ++quad;
        if (quad != told.quads.end() && quad->quad == lane / 4) quad_levels(*quad);
        while (probe != told.probes.end() && probe->lane < lane)
            ++probe;
        for (int number = 0; probe != told.probes.end() && probe->lane == lane; ++probe, ++number) {
            sink_.integer("face", probe->face, number);
            for (std::size_t i = 0; i < probe->coordinates.size(); ++i)
                sink_.real("coordinate", probe->coordinates[i], number * 4 + static_cast<int>(i));
            // Of several probes each has two at most.
            for (std::size_t i = 0; i < probe->level_filters; ++i)
                level_filter(told.level_filters[probe->level_filter + i],
                             number * 2 + static_cast<int>(i));
            sink_.color("probe_color", packed(probe->color), number);
        }
        sink_.color("sample", packed(*told.result, lane));
    });
}

void StageAccount::shaded(AccountPart part, const probed::Batch& batch, const ColorPlanes& before) {
    if (!uses_color(*batch.registers)) return;
    entries(part, batch, batch.fragments->live, [&](unsigned lane) {
        sink_.color("before", packed(before, lane));
        sink_.color("color", packed(batch.fragments->color, lane));
    });
}

void StageAccount::environment(const probed::Batch& batch, const probed::Environment& told) {
    shaded({Stage::Environment, told.unit}, batch, *told.previous);
}

void StageAccount::color_sum(const probed::Batch& batch, const ColorPlanes& before) {
    shaded({Stage::ColorSum}, batch, before);
}

void StageAccount::fog(const probed::Batch& batch, const probed::Fog& told) {
    if (!uses_color(*batch.registers)) return;
    entries({Stage::Fog}, batch, batch.fragments->live, [&](unsigned lane) {
        sink_.color("before", packed(*told.before, lane));
        sink_.integer("factor", told.factor[lane]);
        sink_.color("color", packed(batch.fragments->color, lane));
    });
}

void StageAccount::antialias(const probed::Batch& batch, const ColorPlanes& before) {
    if (!uses_color(*batch.registers)) return;
    entries({Stage::Antialias}, batch, batch.fragments->live, [&](unsigned lane) {
        sink_.color("before", packed(before, lane));
        sink_.integer("coverage", batch.fragments->antialias[lane]);
        sink_.color("color", packed(batch.fragments->color, lane));
    });
}

void StageAccount::sample_mask(const probed::Batch& batch, const SampleMasks& before) {
    entries({Stage::SampleMask}, batch, any_sample(before), [&](unsigned lane) {
        sink_.integer("before", samples_of(before, lane));
        sink_.integer("after", samples_of(batch.fragments->samples, lane));
    });
}

void StageAccount::alpha_test(const probed::Batch& batch, const probed::Test& told) {
    const bool has_color = uses_color(*batch.registers);
    entries({Stage::AlphaTest}, batch, told.before, [&](unsigned lane) {
        if (has_color) sink_.integer("alpha", batch.fragments->color.a[lane]);
        sink_.integer("passed", told.after.test(lane));
    });
}

void StageAccount::stencil_depth(const probed::Batch& batch, const probed::StencilDepth& told) {
    const auto fill = [&](unsigned lane) {
        sink_.integer("stored_depth", told.stored_depth[lane]);
        sink_.integer("stored_stencil", told.stored_stencil[lane]);
        sink_.integer("passed_stencil", told.after_stencil.test(lane));
        sink_.integer("passed_depth", told.after_depth.test(lane));
        sink_.integer("new_depth", told.new_depth[lane]);
        sink_.integer("new_stencil", told.new_stencil[lane]);
    };
    entries({Stage::StencilDepth}, batch, told.before, fill, told.sample);
}

void StageAccount::color_write(const probed::Batch& batch, const probed::ColorWrite& told) {
    const auto fill = [&](unsigned lane) {
        sink_.color("source", packed(batch.fragments->color, lane));
        sink_.color("destination", told.destination[lane]);
        sink_.color("blended", told.blended[lane]);
        sink_.color("stored", told.stored[lane]);
    };
    entries({Stage::ColorWrite, told.target}, batch, told.written, fill, told.sample);
}

} // namespace ffgpu::tools
