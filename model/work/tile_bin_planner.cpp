#include "model/work/tile_bin_planner.h"

#include "model/work/traversal.h"

namespace ffgpu::work {

void TileBinPlanner::plan(std::uint32_t key, const Place& place, TileBin& bin) {
    key_ = key;
    const Rectangle area = bin_rectangle(config_.raster.bin_size, key);
    bin.x = static_cast<std::uint16_t>(area.x0);
    bin.y = static_cast<std::uint16_t>(area.y0);
    take_quads(place, bin);
    collect_clears(place, bin);
    bin.clears = static_cast<std::uint32_t>(clears_.size());
    add_fills(area, bin);
    loads_.clear();
    stores_.clear();
    for (std::size_t target = 0; target < gathered_.targets.size(); ++target)
        plan_target(target, place, bin);
    std::vector<PlacedLine>& lines = sorted_.scene.tiles.lines;
    const auto append = [&](const std::vector<PlacedLine>& more) {
        lines.insert(lines.end(), more.begin(), more.end());
        return static_cast<std::uint32_t>(lines.size());
    };
    bin.loads_begin = append({});
    bin.loads_end = bin.stores_begin = append(loads_);
    bin.stores_end = append(stores_);
}

void TileBinPlanner::take_quads(const Place& place, TileBin& bin) {
    const auto& quads = sorted_.scene.quads;
    bin.quads_begin = next_quad_;
    while (next_quad_ < quads.size() && sorted_.pass_of_quad[next_quad_] == place.pass &&
           screen_bin(config_.raster, quads[next_quad_].x, quads[next_quad_].y) == key_)
        ++next_quad_;
    bin.quads_end = next_quad_;
    const std::vector<BinKey>& keys = sorted_.key_of_piece;
    bin.pieces_begin = next_piece_;
    while (next_piece_ < keys.size() && keys[next_piece_] == bin_key(place.pass, key_))
        ++next_piece_;
    bin.pieces_end = next_piece_;
}

// How the bin begins, and those in its list.
void TileBinPlanner::collect_clears(const Place& place, const TileBin& bin) {
    clears_.clear();
    for (std::uint32_t draw = 0; place.is_first && draw < gathered_.commands.size(); ++draw)
        if (gathered_.commands[draw].is_background) clears_.push_back(draw);
    const TilePlan& plan = sorted_.scene.tiles;
    for (std::uint32_t i = bin.list_begin; i < bin.list_end; ++i) {
        const std::uint32_t draw = plan.records[plan.lists[i]].draw;
        if (gathered_.commands[draw].clear) clears_.push_back(draw);
    }
}

// The quads of a bin come in the order of their draws.
void TileBinPlanner::add_fills(const Rectangle& area, const TileBin& bin) {
    TilePlan& plan = sorted_.scene.tiles;
    std::uint32_t quad = bin.quads_begin;
    for (const std::uint32_t draw : clears_) {
        while (quad < bin.quads_end && sorted_.scene.quads[quad].draw < draw)
            ++quad;
        for (const TargetClear& target : gathered_.commands[draw].clear->targets) {
            TileFill part{quad, target.fill};
            part.fill.rectangle = intersect(part.fill.rectangle, area);
            if (part.fill.mask != 0 && !part.fill.rectangle.empty()) plan.fills.push_back(part);
        }
    }
}

void TileBinPlanner::plan_target(std::size_t target, const Place& place, const TileBin& bin) {
    const TileTarget& place_of_target = gathered_.targets[target];
    TileContents contents(place_of_target,
                          bin_rectangle(config_.raster.bin_size, key_),
                          config_.tiles.detects_overwrite);
    if (contents.pixels().empty()) return;
    auto next_clear = clears_.begin();
    const auto clear_before = [&](std::uint32_t draw) {
        for (; next_clear != clears_.end() && *next_clear < draw; ++next_clear) {
            const TileClear& clear = *gathered_.commands[*next_clear].clear;
            contents.clear(clear.rectangle, clear.targets[target].bytes);
        }
    };
    for (std::uint32_t i = bin.quads_begin; i < bin.quads_end; ++i) {
        const PreparedQuad& quad = sorted_.scene.quads[i];
        clear_before(quad.draw);
        apply(quad, target, contents);
    }
    clear_before(~0u);
    if (is_resolved(target, place)) contents.read_all();
    load_and_store(target, contents, place);
}

bool TileBinPlanner::is_resolved(std::size_t target, const Place& place) const {
    return place.is_last && gathered_.resolve && gathered_.resolve->target == target;
}

void TileBinPlanner::apply(const PreparedQuad& quad,
                           std::size_t target,
                           TileContents& contents) const {
    const TileCommand& command = gathered_.commands[quad.draw];
    if (!gathered_.targets[target].depth) {
        if (command.writes_color) contents.write(quad, command.reads_color);
    } else if (quad.depth_line_count > 0) {
        contents.test(command.depth_read,
                      quad.after_depth != 0 ? command.depth_written : command.stencil_written);
    }
}

void TileBinPlanner::load_and_store(std::size_t target,
                                    const TileContents& contents,
                                    const Place& place) {
    const TileTarget& of = gathered_.targets[target];
    const Rectangle area = bin_rectangle(config_.raster.bin_size, key_);
    if (contents.needs_load()) {
        sorted_.deferred.need(of.surface, key_);
        add_bin_lines(of, area, whole_pixel(of.surface.format).covered, loads_);
    } else if (sorted_.deferred.drop(of.surface, key_, contents.overwritten() | contents.dirty())) {
        ++sorted_.scene.tiles.needless_stores;
    }
    if (is_resolved(target, place)) {
        const TileTarget& destination = gathered_.resolve->destination;
        add_bin_lines(destination, area, whole_pixel(destination.surface.format).covered, stores_);
    }
    if (contents.dirty() == 0) return;
    if (place.is_last && (of.depth || is_resolved(target, place)))
        return sorted_.deferred.defer(of, key_, contents.dirty());
    add_bin_lines(of, area, contents.dirty(), stores_);
}

} // namespace ffgpu::work
