#include "model/timing/depth_timing.h"

#include "model/work/surface_lines.h"

#include <bit>
#include <utility>

namespace ffgpu::timing {
namespace {

// Of what a quad writes to pixels with stencil values: their depths alone, which is all that is
// known where the pixels were not read.
work::WrittenBytes depths_alone(work::WrittenBytes written, const work::LineGrain& grain) {
    constexpr LineMask OneByte = 0xeeeeeeeeeeeeeeee, TwoBytes = 0xaaaaaaaaaaaaaaaa;
    if (grain.bytes() == 1) return {written.touched & OneByte, written.covered & OneByte};
    return {written.touched, grain.bytes() == 2 ? written.covered & TwoBytes : 0};
}

bool has_stencil(const PreparedDraw& draw) {
    return draw.state->targets.depth.format == Format::Depth24Stencil8;
}

// The lanes that have a sample in the mask.
std::uint8_t lanes_of(SampleBits samples) {
    unsigned lanes = 0;
    for_each_sample(samples, [&](unsigned lane, unsigned) { lanes |= 1u << lane; });
    return static_cast<std::uint8_t>(lanes);
}

} // namespace

DepthTiming::DepthTiming(sc_core::sc_module_name name,
                         const Clock& clock,
                         const TimingConfig& config,
                         const Ports& ports,
                         InFlight& in_flight,
                         std::function<void(const QuadToken&, Cycle)> on_late_end)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , in_flight_(in_flight)
    , orders_writes_(ports.blocks != nullptr ||
                     config.depth.test == work::DepthTest::EarlyWhereExact)
    , early_(config.depth_cache.fragment_fifo * config.raster.quads_per_cycle)
    , late_(config.depth_cache.fragment_fifo * config.raster.quads_per_cycle)
    , interlock_(config.depth_cache.fragment_fifo)
    , on_late_end_(std::move(on_late_end)) {
    go_on_while_busy();
}

bool DepthTiming::tests_here(Path path, const PreparedDraw& draw) const {
    if (!draw.uses_depth()) return false;
    return draw.tests_twice || draw.early_depth == (path == Path::Early);
}

bool DepthTiming::writes_late(const PreparedDraw& draw) const {
    return draw.uses_depth() && draw.writes_depth && !draw.early_depth;
}

// --- The coarse test ---------------------------------------------------------------------------

bool DepthTiming::test_coarse(const QuadToken& token, Budget& budget, bool& culled) {
    const PreparedDraw& draw = token.draw();
    if (!ports_.coarse || coarse_ != Coarse::Untested || !draw.value_kinds.depths) return true;
    if (budget.tests == 0) return false;
    --budget.tests;
    HierarchicalDepth& coarse = *ports_.coarse;
    ++coarse.statistics.tested;
    const PreparedQuad& quad = token.quad();
    switch (coarse.test(draw, quad, token.values().depths)) {
    case HierarchicalDepth::Verdict::Fails:
        culled = true;
        ++budget.culled;
        cull(token);
        return false;
    case HierarchicalDepth::Verdict::Passes:
        check(!draw.early_depth || quad.after_early_depth == quad.covered,
              "what passes for certain passes");
        coarse_ = draw.early_depth ? Coarse::Accepted : Coarse::Undecided;
        coarse.statistics.accepted += draw.early_depth;
        return true;
    case HierarchicalDepth::Verdict::Unknown:
        break;
    }
    coarse_ = Coarse::Undecided;
    return true;
}

void DepthTiming::cull(const QuadToken& token) {
    const PreparedQuad& quad = token.quad();
    check(quad.after_depth == 0, "what fails for certain fails");
    HierarchicalDepthStatistics& statistics = ports_.coarse->statistics;
    ++statistics.culled;
    statistics.culled_fragments += static_cast<unsigned>(std::popcount(quad.covered));
    statistics.saved_lines += quad.depth_line_count;
    if (quad.after_early_depth != 0) statistics.saved_textures += quad.texel_line_count;
    token.scene().end_dead_quad(token, now());
    in_flight_.leave();
}

// --- Order between the paths -------------------------------------------------------------------

bool DepthTiming::waits_for_others(const QuadToken& token) const {
    const PreparedQuad& quad = token.quad();
    return orders_writes_ &&
           pending_.any(PendingWrites::place(token.draw().depth_place.base, quad.x, quad.y));
}

// The quad goes on to the late test.
void DepthTiming::announce(const QuadToken& token) {
    const PreparedDraw& draw = token.draw();
    const PreparedQuad& quad = token.quad();
    pending_.add(PendingWrites::place(draw.depth_place.base, quad.x, quad.y));
    if (!ports_.coarse) return;
    for (const std::uint64_t line : token.part->work.depth_lines(quad))
        ports_.coarse->pending.add(line);
    if (draw.state->depth.write_enable) ports_.coarse->widen(draw, quad, token.values().depths);
}

// Its late test is done.
void DepthTiming::complete(const QuadToken& token) {
    const PreparedDraw& draw = token.draw();
    const PreparedQuad& quad = token.quad();
    pending_.done(PendingWrites::place(draw.depth_place.base, quad.x, quad.y));
    if (!ports_.coarse) return;
    for (const std::uint64_t line : token.part->work.depth_lines(quad))
        ports_.coarse->pending.done(line);
}

// --- Look-ups ----------------------------------------------------------------------------------

// Of the quad's `line`-th line. Where values are followed, stencil operations write each pixel that
// comes to its test.
work::WrittenBytes
DepthTiming::written_bytes(Path path, const QuadToken& token, std::size_t line) const {
    const PreparedDraw& draw = token.draw();
    const work::PreparedQuads& quads = token.part->work;
    if (!draw.writes_depth || (path == Path::Early && draw.tests_twice)) return {};
    if (!ports_.blocks || !draw.value_kinds.tested_mask)
        return quads.depth_bytes(token.quad(), line);
    const PreparedQuad& quad = token.quad();
    const SampleBits samples = token.values().depth_words.samples;
    return quad_bytes(draw.depth_place,
                      ports_.cache.grain(),
                      {draw.depth_place.quad_addresses(quad.x, quad.y), lanes_of(samples), samples},
                      quads.depth_lines(quad)[line],
                      work::whole_pixel(draw.state->targets.depth.format));
}

// Of the quad's `line`-th line, what its test needs: of covered pixels, all samples. Where no line
// lacks a byte it is the same to need all.
LineMask DepthTiming::bytes_read(const QuadToken& token, std::size_t line) const {
    if (!ports_.cache.lacks_bytes()) return LineAccess::Whole;
    const PreparedDraw& draw = token.draw();
    const PreparedQuad& quad = token.quad();
    const auto samples = static_cast<SampleBits>(lanes_to_samples(quad.covered) * 0xf);
    return quad_bytes(draw.depth_place,
                      ports_.cache.grain(),
                      {draw.depth_place.quad_addresses(quad.x, quad.y), quad.covered, samples},
                      token.part->work.depth_lines(quad)[line],
                      {draw.depth_bytes_read, draw.depth_bytes_read})
        .touched;
}

LineAccess DepthTiming::access(Path path, const QuadToken& token, std::size_t line) const {
    const PreparedDraw& draw = token.draw();
    work::WrittenBytes written = written_bytes(path, token, line);
    const bool accepted = path == Path::Early && coarse_ == Coarse::Accepted;
    if (accepted && has_stencil(draw)) written = depths_alone(written, ports_.cache.grain());
    return {.number = token.part->work.depth_lines(token.quad())[line],
            .read = accepted || !draw.reads_depth() ? 0 : bytes_read(token, line),
            .written = written.touched,
            .covered = written.covered};
}

// True: all lines of the quad are looked up, or it has none to look up here.
bool DepthTiming::look_up_lines(Path path,
                                const QuadToken& token,
                                Budget& budget,
                                Activity& reason) {
    const PreparedDraw& draw = token.draw();
    LineWalk& walk = path == Path::Early ? early_walk_ : late_walk_;
    ParkedQuads& parked = path == Path::Early ? early_ : late_;
    const std::size_t lines = token.quad().depth_line_count;
    while (walk.next < lines && budget.lookups > 0) {
        const LineAccess wanted = access(path, token, walk.next);
        const bool nothing = wanted.read == 0 && wanted.written == 0;
        if (nothing) {
            ++walk.next;
            continue;
        }
        if (!walk.look_up(ports_.cache, wanted)) {
            if (walk.lacks_port) parked.count_look_up(budget.lookups); // It takes all the cycle.
            break;
        }
        parked.count_look_up();
        if (observer_) observer_->depth_line(name_of(token), {wanted.number, walk.missed, now()});
        --budget.lookups;
        if (ports_.blocks && draw.has_values && wanted.written != 0)
            ports_.blocks->write(draw.depth_place,
                                 token.quad(),
                                 token.values().depth_words,
                                 wanted.number,
                                 draw.value_kinds.tested_mask);
    }
    if (walk.next == lines) return true;
    if (budget.lookups > 0) blame(reason, Activity::StalledRequests);
    return false;
}

// Takes one quad in and looks its line up if it is tested on this path.
template <DepthTiming::Path path>
[[gnu::always_inline]] inline bool DepthTiming::look_up(Budget& budget, Activity& reason) {
    if (is_past_cache(path)) return read_pixels(budget, reason);
    Channel<QuadToken>& in = path == Path::Early ? ports_.early_in : ports_.late_in;
    ParkedQuads& parked = path == Path::Early ? early_ : late_;
    if (parked.is_full()) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const QuadToken token = in.front();
    const PreparedDraw& draw = token.draw();
    LineWalk& walk = path == Path::Early ? early_walk_ : late_walk_;
    const bool early = path == Path::Early;
    bool culled = false;
    if (early && !test_coarse(token, budget, culled)) {
        if (culled) in.drop();
        return culled;
    }
    if (tests_here(path, draw)) {
        if (early && waits_for_others(token)) {
            blame(reason, Activity::StalledOutput);
            return false;
        }
        const std::size_t before = walk.next;
        if (!look_up_lines(path, token, budget, reason)) return walk.next > before;
    }
    if (early && draw.early_depth && ports_.coarse && draw.has_values && draw.writes_depth)
        ports_.coarse->widen(draw, token.quad(), token.values().depths);
    const bool goes_on = token.quad().after_early_depth != 0;
    if (orders_writes_ && writes_late(draw) && goes_on) early ? announce(token) : complete(token);
    if (early) coarse_ = Coarse::Untested;
    in.drop();
    parked.park(token, walk.end());
    return true;
}

// Sends the oldest quad on if its data have come, or ends it if no fragment is left.
template <DepthTiming::Path path>
bool DepthTiming::send(Activity& reason) {
    ParkedQuads& parked = path == Path::Early ? early_ : late_;
    Channel<QuadToken>& out = path == Path::Early ? ports_.early_out : ports_.late_out;
    if (!parked.front_has_data(ports_.cache)) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const PreparedQuad& quad = parked.front().quad();
    const bool dies = (path == Path::Early ? quad.after_early_depth : quad.after_depth) == 0;
    if (!dies && !out.can_push()) {
        blame(reason, Activity::StalledOutput);
        return false;
    }
    const QuadToken token = parked.pop();
    if (is_past_cache(path)) store_pixels(token);
    if (dies) {
        if (path == Path::Late) on_late_end_(token, now());
        token.scene().end_dead_quad(token, now());
        in_flight_.leave();
    } else {
        out.push(token);
    }
    return true;
}

// Quads that the coarse test ends: tests_per_cycle of them cost a pipe what one costs that goes on.
template <DepthTiming::Path path>
bool DepthTiming::work(Budget& budget, Activity& reason) {
    const ParkedQuads& parked = path == Path::Early ? early_ : late_;
    const Channel<QuadToken>& in = path == Path::Early ? ports_.early_in : ports_.late_in;
    if (parked.empty() && !in.can_pop()) return false;
    const std::uint32_t pipes = config_.raster.quads_per_cycle;
    bool worked = false;
    for (std::uint32_t i = 0; i < pipes && !parked.empty() && send<path>(reason); ++i)
        worked = true;
    for (std::uint32_t taken = 0; in.can_pop() && look_up<path>(budget, reason);) {
        worked = true;
        const std::uint32_t ended =
            budget.culled == 0 ? 0 : budget.culled / config_.hierarchical_depth.tests_per_cycle;
        if (++taken - budget.culled + ended >= pipes) break;
    }
    return worked;
}

Activity DepthTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    interlock_.begin_cycle(now());
    Activity reason = Activity::Idle;
    const std::uint32_t pipes = config_.raster.quads_per_cycle;
    Budget budget{.lookups = config_.depth_cache.lookups_per_cycle * pipes,
                  .tests = config_.hierarchical_depth.tests_per_cycle * pipes};
    bool worked = work<Path::Late>(budget, reason);
    worked |= work<Path::Early>(budget, reason);
    if (interlock_.changes()) blame(reason, Activity::StalledMemory); // Stores are under way.
    if (!worked) return reason;
    // Past the cache a quad of which nothing is left ends where there is no place.
    const bool late_is_full = late_.is_full() && !is_past_cache(Path::Late);
    const bool takes_none = (early_.is_full() || !ports_.early_in.can_pop()) &&
                            (late_is_full || !ports_.late_in.can_pop());
    if (takes_none && early_.rests(ports_.cache) && late_.rests(ports_.cache) &&
        ports_.cache.rests() && !interlock_.changes())
        rest_as(early_.empty() && late_.empty() ? Activity::Idle : Activity::StalledMemory);
    return Activity::Busy;
}

} // namespace ffgpu::timing
