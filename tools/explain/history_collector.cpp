// Whose fragments are watched, and what becomes of a batch as a whole; collected_stages.cpp has the
// stages one by one.

#include "tools/explain/history_collector.h"

#include "model/base/check.h"
#include "model/device/primitive_vertices.h"
#include "model/memory/pixel_format.h"
#include "model/raster/setup_record.h"
#include "tools/explain/stippled_out.h"

#include <algorithm>

namespace ffgpu::tools {
namespace {

PrimitiveNote noted(const Primitive& primitive) {
    PrimitiveNote note{primitive.shape, primitive.front_facing, {}};
    const unsigned corners = static_cast<unsigned>(primitive.shape) + 1;
    for (unsigned i = 0; i < corners; ++i)
        note.vertices.push_back(*primitive.vertices[i]);
    return note;
}

unsigned sample_bits(const SampleMasks& samples, unsigned lane) {
    unsigned bits = 0;
    for (unsigned i = 0; i < MaxSamples; ++i)
        bits |= unsigned{samples[i].test(lane)} << i;
    return bits;
}

FragmentEnd end_of_visits(const FragmentNote& note) {
    const auto any = [&](auto&& passed) { return std::ranges::any_of(note.visits, passed); };
    if (note.visits.empty() || any([](const DepthVisit& v) { return v.passed_depth; }))
        return FragmentEnd::Written;
    if (note.visits.front().early) return FragmentEnd::EarlyDepth;
    return any([](const DepthVisit& v) { return v.passed_stencil; }) ? FragmentEnd::Depth
                                                                     : FragmentEnd::Stencil;
}

// Early visits come before the sample mask and the alpha test, late ones behind them.
FragmentEnd end_of(const FragmentNote& note) {
    const FragmentEnd visits = end_of_visits(note);
    if (visits == FragmentEnd::EarlyDepth) return visits;
    if (note.sample_mask && (*note.sample_mask)[1] == 0) return FragmentEnd::Coverage;
    if (note.alpha_passed && !*note.alpha_passed) return FragmentEnd::Alpha;
    return visits;
}

} // namespace

HistoryCollector::HistoryCollector(std::span<PixelHistory> histories)
    : histories_(histories) {
    for (std::size_t i = 0; i < histories.size(); ++i)
        for (std::size_t j = 0; j < histories[i].places.size(); ++j) {
            const PixelPlace& place = histories[i].places[j];
            by_color_.emplace(place.color.address(), watches_.size());
            for (const SurfacePixel& depth : place.depths)
                by_depth_.emplace(depth.address(), watches_.size());
            x0_ = std::min(x0_, place.color.x);
            y0_ = std::min(y0_, place.color.y);
            x1_ = std::max(x1_, place.color.x + 1);
            y1_ = std::max(y1_, place.color.y + 1);
            watches_.push_back({i, j, histories[i].before[j]});
        }
}

void HistoryCollector::begin_draw(std::uint32_t draw, std::size_t step, const TapeStep& what) {
    draws_[draw] = {step, &what};
}

// Those that the fragment at (x, y) may write; where it can write none, those whose depths it sees.
std::vector<std::size_t> HistoryCollector::watches_at(const Targets& targets,
                                                      unsigned x,
                                                      unsigned y,
                                                      std::size_t step) const {
    std::vector<std::size_t> found;
    const auto add = [&](const auto& by_address, const Surface& surface) {
        if (surface.format == Format::None || x >= surface.width || y >= surface.height) return;
        const auto [begin, end] = by_address.equal_range(SurfacePixel{surface, x, y}.address());
        for (auto i = begin; i != end; ++i)
            if (step < place(watches_[i->second]).until &&
                std::ranges::find(found, i->second) == found.end())
                found.push_back(i->second);
    };
    for (const Surface& color : targets.color)
        add(by_color_, color);
    if (found.empty()) add(by_depth_, targets.depth);
    std::ranges::sort(found);
    return found;
}

std::shared_ptr<const DrawState> HistoryCollector::state_of(const probed::Batch& batch) {
    std::shared_ptr<const DrawState>& state = states_[batch.draw];
    if (!state)
        state = std::make_shared<const DrawState>(
            compile_draw_state(std::make_shared<const Registers>(*batch.registers), batch.draw));
    return state;
}

CallName HistoryCollector::call_of(std::uint32_t draw, std::uint32_t primitive) const {
    const TapeStep& step = *draws_.at(draw).what;
    if (!step.vertices) return step.call;
    const auto command = step.as<DrawCommand>();
    const std::uint32_t end = is_independent(command.primitive)
                                  ? vertices_of_one(command.primitive) * (primitive + 1)
                                  : command.count;
    const std::uint32_t last = command.first + end - 1;
    const CallName* const call = step.vertices->call_of(last);
    return call ? *call : step.call;
}

void HistoryCollector::set_up(const probed::SetUp& told) {
    const SetupRecord* const record = told.record;
    const bool may_reach = record && !intersect(record->box,
                                                {static_cast<int>(x0_),
                                                 static_cast<int>(y0_),
                                                 static_cast<int>(x1_),
                                                 static_cast<int>(y1_)})
                                          .empty();
    // The piece is counted in the record, also where it covers nothing.
    if (may_reach)
        primitives_[{told.draw, told.primitive->key, record->piece}] =
            std::make_shared<const PrimitiveNote>(noted(*told.primitive));
    const Scissor& scissor = told.registers->scissor;
    const bool holds_all = scissor.x <= static_cast<int>(x0_) &&
                           scissor.y <= static_cast<int>(y0_) &&
                           scissor.x + scissor.width >= static_cast<int>(x1_) &&
                           scissor.y + scissor.height >= static_cast<int>(y1_);
    if (!holds_all && told.primitive->shape == PrimitiveShape::Triangle)
        note_cut(told, noted(*told.primitive));
    if (may_reach && record->stipple != StippleKind::None) note_stippled_out(told);
}

void HistoryCollector::note_cut(const probed::SetUp& told, const PrimitiveNote& primitive) {
    const Scissor& scissor = told.registers->scissor;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const SurfacePixel& pixel = place(watches_[i]).color;
        const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
        if (x >= scissor.x && x < scissor.x + scissor.width && y >= scissor.y &&
            y < scissor.y + scissor.height)
            continue;
        const std::vector<double> weights = primitive.weights(pixel.x, pixel.y);
        if (weights.empty() || std::ranges::min(weights) < 0) continue;
        note_unmade(PixelEvent::Kind::Scissor, told, i);
    }
}

void HistoryCollector::note_stippled_out(const probed::SetUp& told) {
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const SurfacePixel& pixel = place(watches_[i]).color;
        const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
        if (is_stippled_out(*told.record, *told.registers, x, y))
            note_unmade(PixelEvent::Kind::Stipple, told, i);
    }
}

// A primitive covers the watched pixel's place in the window, but makes no fragment there.
void HistoryCollector::note_unmade(PixelEvent::Kind why,
                                   const probed::SetUp& told,
                                   std::size_t watch) {
    const DrawOrigin origin = draws_.at(told.draw);
    const SurfacePixel& pixel = place(watches_[watch]).color;
    const auto reached = watches_at(told.registers->targets, pixel.x, pixel.y, origin.step);
    if (std::ranges::find(reached, watch) == reached.end()) return;
    history(watches_[watch])
        .events.push_back({.kind = why,
                           .step = origin.step,
                           .place = watches_[watch].place,
                           .call = call_of(told.draw, told.primitive->key),
                           .draw = told.draw,
                           .primitive = told.primitive->key});
}

void HistoryCollector::coverage(const probed::Batch& batch, const probed::Coverage& told) {
    end_batch();
    const FragmentBatch& fragments = *batch.fragments;
    const std::size_t step = draws_.at(batch.draw).step;
    for (unsigned lane = 0; lane < fragments.lanes(); ++lane) {
        if (!fragments.live.test(lane)) continue;
        const unsigned x = fragments.x[lane / 4] + (lane & 1),
                       y = fragments.y[lane / 4] + (lane >> 1 & 1);
        if (x < x0_ || x >= x1_ || y < y0_ || y >= y1_) continue;
        std::vector<std::size_t> watches = watches_at(batch.registers->targets, x, y, step);
        if (watches.empty()) continue;
        tracked_.push_back({lane, note_of(batch, told, lane), std::move(watches)});
        fragments_[batch.draw].push_back(tracked_.back().note);
    }
}

std::shared_ptr<FragmentNote>
HistoryCollector::note_of(const probed::Batch& batch, const probed::Coverage& told, unsigned lane) {
    const FragmentBatch& fragments = *batch.fragments;
    const unsigned quad = lane / 4;
    auto note = std::make_shared<FragmentNote>();
    note->key = probed::key_of(batch, lane);
    note->piece = batch.pieces[quad];
    note->x = fragments.x[quad] + (lane & 1);
    note->y = fragments.y[quad] + (lane >> 1 & 1);
    note->state = state_of(batch);
    if (note->state->samples > 1) note->samples_covered = sample_bits(fragments.samples, lane);
    note->image = batch.runs.empty();
    if (note->image) {
        note_image(batch, lane, *note);
        return note;
    }
    const probed::Run* run = batch.runs.data();
    for (const probed::Run& next : batch.runs)
        if (next.first_quad <= quad) run = &next;
    note->front_facing = run->record->front_facing;
    for (unsigned i = 0; i < run->record->edge_count; ++i)
        note->edges.push_back(told.edges[i][lane]);
    const auto primitive = primitives_.find({batch.draw, note->key.primitive, note->piece});
    check(primitive != primitives_.end(), "a fragment of a primitive that was never set up");
    note->primitive = primitive->second;
    return note;
}

void HistoryCollector::note_image(const probed::Batch& batch,
                                  unsigned lane,
                                  FragmentNote& note) const {
    const FragmentBatch& fragments = *batch.fragments;
    const auto color = [lane](const ColorPlanes& planes) {
        return Rgba{static_cast<std::uint8_t>(planes.r[lane]),
                    static_cast<std::uint8_t>(planes.g[lane]),
                    static_cast<std::uint8_t>(planes.b[lane]),
                    static_cast<std::uint8_t>(planes.a[lane])};
    };
    note.depth = fragments.depth[lane];
    note.has_colors = true;
    note.primary = color(fragments.primary);
    note.secondary = color(fragments.secondary);
    note.fog_coordinate = fragments.fog_coordinate[lane];
}

void HistoryCollector::end_batch() {
    for (Tracked& tracked : tracked_)
        end_fragment(tracked);
    tracked_.clear();
}

// Its writes become part of the pixels' values: what a write found there is what was left before.
void HistoryCollector::end_fragment(Tracked& tracked) {
    FragmentNote& note = *tracked.note;
    note.end = end_of(note);
    const Targets& targets = note.registers().targets;
    for (const std::size_t i : tracked.watches) {
        Watch& watch = watches_[i];
        const SurfacePixel& pixel = place(watch).color;
        for (const WriteNote& write : note.writes) {
            const Surface& surface = targets.color[write.target];
            if (SurfacePixel{surface, note.x, note.y}.address() != pixel.address()) continue;
            check(!(surface == pixel.surface) ||
                      watch.value.color[write.sample] == write.destination,
                  "a pixel changed between two events of its history");
            watch.value.color[write.sample] = write.stored;
        }
        history(watch).events.push_back({.step = draws_.at(note.key.draw).step,
                                         .place = watch.place,
                                         .call = call_of(note.key.draw, note.key.primitive),
                                         .draw = note.key.draw,
                                         .primitive = note.key.primitive,
                                         .piece = note.piece,
                                         .fragment = tracked.note,
                                         .after = watch.value});
    }
}

std::vector<std::shared_ptr<FragmentNote>>
HistoryCollector::fragments_of(std::uint32_t draw) const {
    const auto found = fragments_.find(draw);
    return found == fragments_.end() ? std::vector<std::shared_ptr<FragmentNote>>{} : found->second;
}

} // namespace ffgpu::tools
