#include "model/work/tile_scene.h"

#include "model/work/draw_preparation.h"
#include "model/work/target_access.h"
#include "model/work/tile_planner.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {

void TileScene::begin(const Targets& targets) {
    if (!empty()) return;
    targets_ = targets;
    places_.clear();
    const auto add = [&](const Surface& surface, bool depth) {
        if (surface.format == Format::None) return;
        const CacheShape& cache = depth ? config_.depth_cache : config_.color_cache;
        places_.push_back({surface, addresses_.surface(surface, cache), cache.line_bytes, depth});
    };
    for (const Surface& color : targets.color)
        add(color, false);
    add(targets.depth, true);
}

void TileScene::draw(const WholeCommand& command) {
    const Registers* const state = command.draw.state.get();
    begin(state ? state->targets : Targets{});
    DrawPreparation preparation(command, config_, addresses_, scene_);
    std::vector<PieceEnd> ends;
    preparation.add_quads(preparation.quads_left(), scene_, ends);
    set_ends(ends, scene_);
    const PreparedDraw& draw = scene_.draws.back();
    TileCommand& added = commands_.emplace_back();
    added.reads_color = draw.reads_color || draw.masks_color;
    added.writes_color = draw.writes_color;
    if (!state || !draw.uses_depth()) return;
    const Format format = state->targets.depth.format;
    const DepthAccess access = depth_access(*state);
    const PixelBytes depth = cleared_depth_bytes(format, {.depth = true}, 0);
    const PixelBytes stencil = cleared_depth_bytes(format, {.stencil = true}, 0xff);
    const PixelBytes failed{access.depth_failed.touched | access.stencil_failed.touched,
                            access.depth_failed.covered & access.stencil_failed.covered};
    added.depth_written = access.depth.touched | access.passed.touched;
    added.stencil_written = failed.touched;
    if (access.tests_depth) added.depth_read |= depth.covered;
    if (access.tests_stencil || (access.passed.touched & ~access.passed.covered) != 0 ||
        (failed.touched & ~failed.covered) != 0)
        added.depth_read |= stencil.covered;
}

// A command that has no quads: one primitive takes it through the geometry units.
PreparedDraw& TileScene::add_command(const WorkDraw& command) {
    PreparedDraw& draw = scene_.draws.emplace_back();
    draw.kind = command.kind;
    draw.number = command.number;
    draw.register_writes = command.register_writes;
    draw.register_words = command.register_words;
    draw.first_primitive = static_cast<std::uint32_t>(scene_.primitives.size());
    draw.primitive_count = 1;
    scene_.primitives.push_back(
        {.first_piece = static_cast<std::uint32_t>(scene_.pieces.size()), .piece_count = 1});
    const auto here = static_cast<std::uint32_t>(scene_.quads.size());
    scene_.pieces.push_back({.begin = here, .end = here, .box = {}});
    draw.first_quad = static_cast<std::uint32_t>(scene_.quads.size());
    commands_.emplace_back();
    return draw;
}

void TileScene::clear(const WorkDraw& command) {
    const Registers& state = *command.state;
    begin(state.targets);
    const bool is_first = std::all_of(commands_.begin(), commands_.end(), [](const auto& before) {
        return before.is_background;
    });
    add_command(command);
    TileClear clear{.rectangle = cleared_rectangle(state), .targets = target_clears(command)};
    bool is_whole = true;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const TileTarget& target = places_[i];
        clear.targets[i].fill.place = target.place;
        const Rectangle all{0, 0, target.surface.width, target.surface.height};
        is_whole = is_whole && clear.rectangle == all;
    }
    commands_.back().is_background = is_first && is_whole;
    commands_.back().clear = std::move(clear);
}

bool TileScene::resolve(const WorkDraw& command) {
    const CopyRectangleCommand& copy = command.copy;
    const auto target = std::find_if(places_.begin(), places_.end(), [&](const TileTarget& place) {
        return place.surface == copy.source && !place.depth;
    });
    if (empty() || target == places_.end()) return false;
    const Surface &from = copy.source, &to = copy.destination;
    if (copy.pictures > 1 || from.samples == 1 || to.samples != 1 || from.format != to.format)
        return false;
    if (copy.source_x != 0 || copy.source_y != 0 || copy.destination_x != 0 ||
        copy.destination_y != 0 || copy.width != from.width || copy.height != from.height)
        return false;
    resolve_ = TileResolve{
        static_cast<std::size_t>(target - places_.begin()),
        {to, addresses_.surface(to, config_.color_cache), config_.color_cache.line_bytes, false}};
    add_command(command);
    return true;
}

PreparedScene TileScene::take(DeferredStores& deferred) {
    const GatheredScene gathered{places_, commands_, resolve_};
    TilePlanner(config_, gathered, scene_).run(deferred);
    commands_.clear();
    resolve_.reset();
    return std::exchange(scene_, {});
}

} // namespace ffgpu::work
