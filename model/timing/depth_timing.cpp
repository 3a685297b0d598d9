#include "model/timing/depth_timing.h"

#include "model/work/surface_lines.h"

namespace ffgpu::timing {

DepthTiming::DepthTiming(sc_core::sc_module_name name,
                         const Clock& clock,
                         const TimingConfig& config,
                         const Ports& ports,
                         InFlight& in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , in_flight_(in_flight)
    , early_(config.depth_cache.fragment_fifo * config.raster.quads_per_cycle)
    , late_(config.depth_cache.fragment_fifo * config.raster.quads_per_cycle) {}

// Takes one quad in and looks its line up if it is tested on this path.
bool DepthTiming::look_up(Path path, std::uint32_t& lookups_left, Activity& reason) {
    Channel<QuadToken>& in = path == Path::Early ? ports_.early_in : ports_.late_in;
    ParkedQuads& parked = path == Path::Early ? early_ : late_;
    if (!in.can_pop()) return false;
    if (parked.is_full()) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const QuadToken token = in.front();
    const PreparedDraw& draw = token.draw();
    const bool tested_here = draw.uses_depth && draw.early_depth == (path == Path::Early);
    LineWalk& walk = path == Path::Early ? early_walk_ : late_walk_;
    if (tested_here) {
        const auto lines = token.scene->work.depth_lines(token.quad());
        const bool writes = draw.writes_depth && token.quad().after_depth != 0;
        const std::size_t before = walk.next;
        while (walk.next < lines.size() && lookups_left > 0) {
            const std::uint64_t line = lines[walk.next];
            const work::WrittenBytes written =
                writes ? quad_bytes(draw.depth_place, ports_.cache.grain(), token.quad(), line)
                       : work::WrittenBytes{};
            if (!walk.look_up(
                    ports_.cache,
                    {.number = line, .written = written.touched, .covered = written.covered}))
                break;
            --lookups_left;
        }
        if (walk.next < lines.size()) {
            if (lookups_left > 0) blame(reason, Activity::StalledRequests);
            return walk.next > before;
        }
    }
    in.pop();
    parked.park(token, walk.end());
    return true;
}

// Sends the oldest quad on if its data have come, or ends it if no fragment is left.
bool DepthTiming::send(Path path, Activity& reason) {
    ParkedQuads& parked = path == Path::Early ? early_ : late_;
    Channel<QuadToken>& out = path == Path::Early ? ports_.early_out : ports_.late_out;
    if (parked.empty()) return false;
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
    if (dies) {
        token.scene->end_dead_quad(token.index, now());
        in_flight_.leave();
    } else {
        out.push(token);
    }
    return true;
}

Activity DepthTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    Activity reason = Activity::Idle;
    bool worked = false;
    std::uint32_t lookups_left =
        config_.depth_cache.lookups_per_cycle * config_.raster.quads_per_cycle;
    for (const Path path : {Path::Late, Path::Early}) {
        for (std::uint32_t i = 0; i < config_.raster.quads_per_cycle && send(path, reason); ++i)
            worked = true;
        for (std::uint32_t i = 0;
             i < config_.raster.quads_per_cycle && look_up(path, lookups_left, reason);
             ++i)
            worked = true;
    }
    return worked ? Activity::Busy : reason;
}

} // namespace ffgpu::timing
