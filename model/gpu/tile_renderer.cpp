#include "model/gpu/tile_renderer.h"

#include "model/arith/range.h"
#include "model/arith/reciprocal.h"
#include "model/memory/clear.h"
#include "model/raster/image_fragments.h"
#include "model/raster/smooth_coverage.h"

namespace ffgpu {
namespace {

// All four by the range rule; of cube maps q does not matter.
TexCoordPlanes constant_coordinates(const std::array<float, 4>& value, bool cube) {
    const float q = in_range(value[3]);
    const float over_q = cube ? 1.0f : reciprocal(q == 0 ? LeastValue : q);
    TexCoordPlanes planes;
    planes.s.fill(in_range(value[0]) * over_q);
    planes.t.fill(in_range(value[1]) * over_q);
    planes.r.fill(in_range(value[2]) * over_q);
    return planes;
}

std::uint64_t area_of(const Rectangle& rectangle) {
    if (rectangle.empty()) return 0;
    return static_cast<std::uint64_t>(rectangle.width()) *
           static_cast<std::uint64_t>(rectangle.height());
}

} // namespace

void TileRenderer::set_probe(StageProbe* probe) {
    tap_ = probe ? std::make_unique<StageTap>(*probe, batch_) : nullptr;
}

void TileRenderer::render(const BinSequence& sequence,
                          std::uint32_t tile,
                          const Recording& recording) {
    const Bin& first = *sequence.bins.front();
    tile_ = first.tile_rectangle(tile);
    tile_number_ = tile;
    cleared_ = &first.cleared();
    if (recording.tile) {
        recording.tile->x = static_cast<std::uint16_t>(tile_.x0);
        recording.tile->y = static_cast<std::uint16_t>(tile_.y0);
    }
    recording_ = recording;
    pixels_ = nullptr;
    drawn_ = {};
    collector_.clear();
    collector_.begin_tile(tile_);
    hidden_.begin_tile(tile_);
    ++counts_.tiles;
    for (const auto& bin : sequence.bins)
        render(*bin);
    flush();
    tell_drawn();
}

void TileRenderer::render(const Bin& bin) {
    command_ = ~0u;
    bin.for_each_step(tile_number_, [&](const Bin::Step& step) {
        if (step.command != command_) {
            begin_command(bin.commands()[step.command]);
            command_ = step.command;
            binned_ = &bin.commands()[step.command];
        }
        if (step.record)
            draw_record(*step.record);
        else
            whole_command(bin.commands()[command_]);
    });
}

// Draws whose pixels are made alike share batches, unless they are to be told apart.
void TileRenderer::begin_command(const BinCommand& command) {
    const PixelContext* const pixels = command.pixels.get();
    if (command.kind == WorkKind::Draw && pixels == pixels_ && !recording_.tile && !tap_) return;
    flush();
    tell_drawn();
    pixels_ = pixels;
    hidden_.begin_draws(pixels->pipe);
    if (pixels_->antialias) batch_.antialias.fill(255);
}

// To those of the targets that pixels_ writes.
void TileRenderer::tell_drawn() {
    if (drawn_.empty()) return;
    const Rectangle area = intersect(std::exchange(drawn_, {}), tile_);
    const FragmentPipe& pipe = pixels_->pipe;
    for (unsigned i = 0; i < cleared_->size(); ++i) {
        const bool writes =
            i < ColorTargets ? pipe.color_targets[i].write_mask != 0 : pipe.stencil_depth.writes();
        if (writes && (*cleared_)[i]) (*cleared_)[i]->draw(tile_number_, area);
    }
}

void TileRenderer::draw_record(const SetupRecord& record) {
    drawn_ = unite(drawn_, record.box);
    if (pixels_->multisample) return draw_samples(record);
    if (record.coverage != CoverageKind::Centre) return draw_smooth(record);
    if (record.stipple == StippleKind::None && fits_windows(record)) return draw_small(record);
    stages_.cover_tile(edge_set(record), tile_, coverage_);
    const bool passes_over = passes_over_hidden();
    for (unsigned i = 0; i < coverage_.count; ++i) {
        BlockCoverage& block = coverage_.blocks[i];
        if (record.stipple != StippleKind::None)
            block.mask &= stipple_mask(record, pixels_->stipple, block.x, block.y);
        if (passes_over && hidden_.hides(record, block))
            count_hidden(block.mask);
        else if (block.mask != 0)
            collector_.add(record, block, nullptr, [this] { flush(); });
    }
}

// Of the primitive whose coverage is known. In meshes of small ones it takes longer to ask than it
// saves. Who is told of each fragment is told of these, too.
bool TileRenderer::passes_over_hidden() const {
    constexpr unsigned FewBlocks = 4;
    return coverage_.count > FewBlocks && stages_.passes_over_hidden && hidden_.tells() &&
           !recording_.tile && !tap_;
}

void TileRenderer::draw_small(const SetupRecord& record) {
    stages_.cover_windows(edge_set(record), tile_, windows_);
    for (unsigned i = 0; i < windows_.count; ++i)
        collector_.add_window(record, windows_.blocks[i], [this] { flush(); });
}

void TileRenderer::draw_samples(const SetupRecord& record) {
    stages_.cover_tile_samples(record, tile_, sample_coverage_);
    for (unsigned i = 0; i < sample_coverage_.count; ++i) {
        SampleBlock& block = sample_coverage_.blocks[i];
        if (record.stipple != StippleKind::None) {
            const BlockMask kept = stipple_mask(record, pixels_->stipple, block.x, block.y);
            for (BlockMask& mask : block.masks)
                mask &= kept;
        }
        if (block.any() != 0) collector_.add_samples(record, block, [this] { flush(); });
    }
}

void TileRenderer::draw_smooth(const SetupRecord& record) {
    const Rectangle area = intersect(record.box, tile_);
    BlockAntialias antialias;
    for (int y = area.y0 & -BlockSize; y < area.y1; y += BlockSize)
        for (int x = area.x0 & -BlockSize; x < area.x1; x += BlockSize) {
            const BlockMask mask = stages_.smooth_block(record, x, y, antialias) &
                                   stipple_mask(record, pixels_->stipple, x, y);
            const BlockCoverage block{
                static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask};
            if (mask != 0) collector_.add(record, block, &antialias, [this] { flush(); });
        }
}

void TileRenderer::whole_command(const BinCommand& command) {
    const Registers& registers = command.context->regs();
    const Rectangle area = intersect(command.context->setup.clip, tile_);
    switch (command.kind) {
    case WorkKind::Clear:
        hidden_.forget();
        return clear(command, area);
    case WorkKind::Image:
        hidden_.forget();
        if (command.image->format != Format::Stencil8) {
            drawn_ = unite(drawn_, area);
            return draw_image(command);
        }
        if (ClearedTiles* const depth = cleared_->back().get()) depth->draw(tile_number_, area);
        return draw_stencil_image(*command.image, registers, area, memory_);
    case WorkKind::Draw:
    case WorkKind::Copy:
        return;
    }
}

// `area`: of the tile. Values that differ from pixel to pixel are as if they were drawn.
void TileRenderer::clear(const BinCommand& command, const Rectangle& area) {
    const Registers& registers = command.context->regs();
    const auto fills = target_fills(command.clear, registers);
    std::size_t place = 0;
    Targets::for_each(registers.targets, [&](const Surface& target) {
        const PixelFill& fill = fills[place];
        ClearedTiles* const cleared = (*cleared_)[place++].get();
        if (fill.mask == 0) return;
        Rectangle changed = area;
        if (cleared && fill.dithered != Format::None) {
            cleared->draw(tile_number_, area);
        } else if (cleared) {
            const bool whole = area == intersect(tile_, {0, 0, target.width, target.height});
            changed = cleared->clear(tile_number_, area, whole, fill.value, fill.mask);
            counts_.kept_clears += area_of(area) - area_of(changed);
        }
        fill_target(target, fill, changed, memory_);
    });
}

void TileRenderer::draw_image(const BinCommand& command) {
    const DrawImageCommand& image = *command.image;
    const auto sink = [&](FragmentBatch& filled) {
        batch_ = filled;
        batch_.tile_x = static_cast<std::uint16_t>(tile_.x0);
        batch_.tile_y = static_cast<std::uint16_t>(tile_.y0);
        const FragmentMask covered = batch_.live;
        if (multisampled()) begin_samples();
        if (tap_) tap_->begin(command, {});
        if (tap_) tap_->coverage();
        early_depth_test(pixels_->pipe, batch_, pipe_tap());
        if (wants_samples() && (batch_.live.any() || records_values())) {
            for (unsigned unit = 0; unit < TextureUnits; ++unit)
                if (pixels_->samples(unit)) {
                    coordinates_ = constant_coordinates(image.tex_coords[unit], is_cube(unit));
                    sample_unit(unit, covered);
                }
        }
        finish_batch(covered);
    };
    image_fragments(image,
                    command.context->state,
                    intersect(command.context->setup.clip, tile_),
                    memory_,
                    sink);
    collector_.clear();
}

// Carries out the batch that was collected.
void TileRenderer::flush() {
    if (collector_.empty()) return;
    const PixelContext& context = *pixels_;
    const std::span<const BatchRun> runs = collector_.runs();
    const FragmentMask covered = batch_.live;

    if (multisampled()) begin_samples();
    if (tap_) tap_->begin(*binned_, runs);
    if (tap_) tap_->coverage();
    if (context.needs_depth) interpolate_depths();
    early_depth_test(context.pipe, batch_, pipe_tap());
    if (keeps_colors()) {
        finish_kept(runs, covered);
    } else {
        if (wants_samples() && (batch_.live.any() || records_values())) shade_units(runs, covered);
        finish_batch(covered);
    }
    if (context.antialias) batch_.antialias.fill(255); // Smooth primitives wrote theirs.
    collector_.clear();
}

// Who is told of stages, or of values, is told of all of them.
bool TileRenderer::keeps_colors() const {
    return pixels_->pipe.keeps_colors && pixels_->draws_colors && pixels_->units == 0 &&
           pixels_->layout.color >= 0 && stages_.packs_kept_colors && !records_values() && !tap_;
}

// Texels that are read without colours are recorded.
bool TileRenderer::wants_samples() const {
    return pixels_->draws_colors || (recording_.tile && pixels_->units != 0);
}

// From the primitives' planes to the texture units' samples.
void TileRenderer::shade_units(std::span<const BatchRun> runs, const FragmentMask& covered) {
    const InterpolantLayout& layout = pixels_->layout;
    if (needs_perspective(layout, runs)) {
        stages_.interpolate_perspective(runs, batch_, perspective_);
        if (tap_) tap_->perspective(perspective_);
    }
    if (pixels_->draws_colors) stages_.interpolate_colors(layout, runs, perspective_, batch_);
    if (tap_) tap_->colors(layout);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (pixels_->samples(unit)) {
            const auto interpolate =
                is_cube(unit) ? stages_.interpolate_directions : stages_.interpolate_tex_coords;
            interpolate(layout, unit, runs, perspective_, batch_, coordinates_);
            if (tap_) tap_->tex_coords(layout, unit, coordinates_);
            sample_unit(unit, covered);
        }
}

// At the samples where primitives cover samples, at the centres where they cover pixels.
void TileRenderer::interpolate_depths() {
    if (pixels_->multisample) {
        stages_.interpolate_sample_depths(collector_.runs(), batch_, sample_depths_);
        batch_.sample_depths = &sample_depths_;
    } else {
        stages_.interpolate_depth(collector_.runs(), batch_);
    }
    if (tap_) tap_->depth();
}

// Primitives that cover pixels cover all samples of them.
void TileRenderer::begin_samples() {
    if (!pixels_->multisample) batch_.samples.fill(batch_.live);
    covered_samples_ = batch_.samples;
    batch_.sample_depths = nullptr;
}

void TileRenderer::sample_unit(unsigned unit, const FragmentMask& covered) {
    TexelFootprints* footprints = nullptr;
    if (recording_.tile) {
        footprints = &footprints_.emplace_back(recording_.memory);
        footprints->unit = static_cast<std::uint8_t>(unit);
    }
    // A machine that tests depth late reads the texels of hidden fragments, too.
    stages_.sample(pixels_->textures[unit],
                   coordinates_,
                   {batch_.quad_count,
                    covered,
                    records_values() ? covered : batch_.live,
                    pixels_->draws_colors},
                   batch_.texture[unit],
                   footprints);
    if (tap_) tap_->sampling(pixels_->textures[unit], unit, coordinates_);
}

void TileRenderer::finish_batch(const FragmentMask& covered) {
    const FragmentMask early = batch_.live;
    if (early.any()) {
        if (pixels_->layout.color >= 0 && pixels_->draws_colors)
            shade(pixels_->pipe, batch_, pipe_tap());
        write(pixels_->pipe, batch_, fates_, pipe_tap());
    } else {
        fates_ = {};
    }
    tell(covered, early);
}

// The same for a batch that keeps_colors(), which is not shaded yet.
void TileRenderer::finish_kept(std::span<const BatchRun> runs, const FragmentMask& covered) {
    const FragmentMask early = batch_.live;
    if (early.any()) {
        interpolate_kept(runs);
        write_kept(pixels_->pipe, colors_, batch_, fates_);
    } else {
        fates_ = {};
    }
    tell(covered, early);
}

void TileRenderer::interpolate_kept(std::span<const BatchRun> runs) {
    const InterpolantLayout& layout = pixels_->layout;
    if (needs_perspective(layout, runs))
        stages_.interpolate_perspective(runs, batch_, perspective_);
    interpolate_color_words(layout, runs, perspective_, batch_.lanes(), colors_.words);
}

void TileRenderer::tell(const FragmentMask& covered, const FragmentMask& early) {
    count(covered, early);
    if (recording_.tile) record(covered, early);
}

} // namespace ffgpu
