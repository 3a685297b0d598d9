#include "model/work/tile_planner.h"

#include "model/work/traversal.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {
namespace {

std::uint32_t size_of(const auto& container) {
    return static_cast<std::uint32_t>(container.size());
}

} // namespace

void TilePlanner::run(DeferredStores& deferred) {
    passes_.resize(1);
    pass_of_quad_.resize(scene_.quads.size());
    for (std::uint32_t draw = 0; draw < scene_.draws.size(); ++draw) {
        if (gathered_.commands[draw].clear) {
            record_clear(draw);
        } else {
            record_draw(draw);
        }
    }
    if (gathered_.resolve) {
        const Surface& surface = gathered_.targets[gathered_.resolve->target].surface;
        touch(bins_in({0, 0, surface.width, surface.height}), passes_.back());
    }
    sort_quads();
    TileBinPlanner bins(config_, gathered_, {scene_, pass_of_quad_, part_keys_, deferred});
    for (const Pass& pass : passes_)
        add_pass(pass, bins);
    for (PreparedQuad& quad : scene_.quads) // Depth and colours are on chip.
        quad.depth_line_count = quad.color_line_count = 0;
}

// A clear of whole targets before all else is how the bins begin; others are drawn.
void TilePlanner::record_clear(std::uint32_t draw) {
    const TileCommand& command = gathered_.commands[draw];
    const bool touches = std::ranges::any_of(
        command.clear->targets, [](const TargetClear& of) { return of.bytes.touched != 0; });
    const std::vector<std::uint32_t> bins =
        bins_in(touches ? command.clear->rectangle : Rectangle{});
    if (command.is_background) {
        touch(bins, passes_.back());
    } else {
        add_record(draw, scene_.primitives[scene_.draws[draw].first_primitive].first_piece, bins);
    }
}

// An image is one record, whatever pieces its pixels make.
void TilePlanner::record_draw(std::uint32_t draw) {
    const PreparedDraw& prepared = scene_.draws[draw];
    const std::uint32_t first = prepared.first_primitive;
    for (std::uint32_t i = first; i < first + prepared.primitive_count; ++i) {
        const PreparedPrimitive& primitive = scene_.primitives[i];
        const std::uint32_t end = primitive.first_piece + primitive.piece_count;
        for (std::uint32_t piece = primitive.first_piece; piece < end; ++piece) {
            PreparedPiece whole = scene_.pieces[piece];
            if (prepared.kind == WorkKind::Image) {
                whole.end = scene_.pieces[end - 1].end;
                piece = end - 1;
            }
            add_record(draw, piece, bins_of(whole));
            std::fill(pass_of_quad_.begin() + whole.begin,
                      pass_of_quad_.begin() + whole.end,
                      size_of(passes_) - 1);
        }
    }
}

void TilePlanner::add_record(std::uint32_t draw,
                             std::uint32_t piece,
                             const std::vector<std::uint32_t>& bins) {
    if (bins.empty()) return;
    if (!passes_.back().records.empty() &&
        bytes_with(bins, passes_.back()) > config_.tiles.parameter_buffer_bytes)
        passes_.emplace_back();
    Pass& pass = passes_.back();
    pass.bytes = bytes_with(bins, pass);
    const std::uint32_t begin = size_of(pass.keys);
    pass.keys.insert(pass.keys.end(), bins.begin(), bins.end());
    pass.bins.insert(bins.begin(), bins.end());
    pass.records.push_back({draw, piece, begin, size_of(pass.keys)});
}

void TilePlanner::touch(const std::vector<std::uint32_t>& bins, Pass& pass) const {
    for (const std::uint32_t bin : bins)
        if (pass.bins.insert(bin).second) pass.bytes += config_.tiles.header_bytes;
}

std::uint64_t TilePlanner::bytes_with(const std::vector<std::uint32_t>& bins,
                                      const Pass& pass) const {
    const auto added = static_cast<std::uint64_t>(std::count_if(
        bins.begin(), bins.end(), [&](std::uint32_t bin) { return !pass.bins.contains(bin); }));
    return pass.bytes + added * config_.tiles.header_bytes + config_.tiles.record_bytes +
           bins.size() * std::uint64_t{config_.tiles.entry_bytes};
}

// A piece whose box is not told has that of its quads.
std::vector<std::uint32_t> TilePlanner::bins_of(const PreparedPiece& piece) const {
    std::vector<std::uint32_t> bins;
    Rectangle box{1 << 16, 1 << 16, 0, 0};
    for (std::uint32_t i = piece.begin; i < piece.end; ++i) {
        const PreparedQuad& quad = scene_.quads[i];
        const std::uint32_t bin = screen_bin(config_.raster, quad.x, quad.y);
        if (bins.empty() || bins.back() != bin) bins.push_back(bin);
        box = {std::min<int>(box.x0, quad.x),
               std::min<int>(box.y0, quad.y),
               std::max<int>(box.x1, quad.x + 1),
               std::max<int>(box.y1, quad.y + 1)};
    }
    if (config_.tiles.binning == Binning::BoundingBox) {
        const PieceBox& told = piece.box;
        return bins_in(told.empty() ? box : Rectangle{told.x0, told.y0, told.x1, told.y1});
    }
    std::sort(bins.begin(), bins.end());
    bins.erase(std::unique(bins.begin(), bins.end()), bins.end());
    return bins;
}

std::vector<std::uint32_t> TilePlanner::bins_in(const Rectangle& rectangle) const {
    std::vector<std::uint32_t> bins;
    if (rectangle.empty()) return bins;
    const auto bin = [&](int x, int y) {
        return screen_bin(
            config_.raster, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    };
    const std::uint32_t first = bin(rectangle.x0, rectangle.y0);
    const std::uint32_t last = bin(rectangle.x1 - 1, rectangle.y1 - 1);
    for (std::uint32_t row = first >> 12; row <= last >> 12; ++row)
        for (std::uint32_t column = first & 0xfff; column <= (last & 0xfff); ++column)
            bins.push_back(row << 12 | column);
    return bins;
}

// Pass by pass, bin by bin. In a bin in whose list a piece stands for its box alone, the box is
// walked.
void TilePlanner::sort_quads() {
    std::vector<BinKey> keys(scene_.quads.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] = bin_key(pass_of_quad_[i],
                          screen_bin(config_.raster, scene_.quads[i].x, scene_.quads[i].y));
    std::vector<PiecePart> walked;
    for (std::uint32_t pass = 0; pass < passes_.size(); ++pass) {
        for (const TileRecord& record : passes_[pass].records) {
            if (gathered_.commands[record.draw].clear || scene_.pieces[record.piece].box.empty())
                continue;
            for (std::uint32_t i = record.bins_begin; i < record.bins_end; ++i)
                walked.push_back({bin_key(pass, passes_[pass].keys[i]), record.piece});
        }
    }
    part_keys_ = work::sort_quads(config_.raster, keys, walked, scene_);
    std::sort(pass_of_quad_.begin(), pass_of_quad_.end());
}

void TilePlanner::add_pass(const Pass& pass, TileBinPlanner& bins) {
    const std::vector<std::uint32_t> keys(pass.bins.begin(), pass.bins.end());
    std::vector<std::vector<std::uint32_t>> lists(keys.size());
    TilePass added{.records_begin = size_of(plan_.records), .bins_begin = size_of(plan_.bins)};
    for (const TileRecord& record : pass.records) {
        TileRecord& copy = plan_.records.emplace_back(record);
        copy.bins_begin = size_of(plan_.record_bins);
        for (std::uint32_t i = record.bins_begin; i < record.bins_end; ++i) {
            const auto bin = static_cast<std::uint32_t>(
                std::lower_bound(keys.begin(), keys.end(), pass.keys[i]) - keys.begin());
            lists[bin].push_back(size_of(plan_.records) - 1);
            plan_.record_bins.push_back(added.bins_begin + bin);
        }
        copy.bins_end = size_of(plan_.record_bins);
    }
    const TileBinPlanner::Place place{.is_first = plan_.passes.empty(),
                                      .is_last = plan_.passes.size() + 1 == passes_.size(),
                                      .pass = size_of(plan_.passes)};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        TileBin& bin = plan_.bins.emplace_back();
        bin.list_begin = size_of(plan_.lists);
        plan_.lists.insert(plan_.lists.end(), lists[i].begin(), lists[i].end());
        bin.list_end = size_of(plan_.lists);
        bins.plan(keys[i], place, bin);
    }
    added.records_end = size_of(plan_.records);
    added.bins_end = size_of(plan_.bins);
    plan_.passes.push_back(added);
}

} // namespace ffgpu::work
