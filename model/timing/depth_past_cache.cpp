// The late depth test without a depth cache: every quad that has a fragment left reads its pixels,
// and stores what it changes.

#include "model/timing/depth_timing.h"

namespace ffgpu::timing {

// Nothing is left of a quad that the alpha test ended: no depth of it is wanted.
bool DepthTiming::end_dead(const QuadToken& token) {
    const bool has_target = token.draw().depth_place.layer_bytes != 0;
    const PreparedQuad& quad = token.quad();
    if (has_target ? quad.depth_line_count != 0 : quad.after_alpha != 0) return false;
    token.scene().end_dead_quad(token, now());
    in_flight_.leave();
    ports_.late_in.pop();
    return true;
}

bool DepthTiming::read_pixels(Budget& budget, Activity& reason) {
    const QuadToken token = ports_.late_in.front();
    if (end_dead(token)) return true;
    if (late_.is_full() || !interlock_.admits(token.quad())) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const auto lines = token.part->work.depth_lines(token.quad());
    const std::size_t before = late_walk_.next;
    for (; late_walk_.next < lines.size() && budget.lookups > 0; --budget.lookups) {
        if (!late_walk_.read(ports_.cache, lines[late_walk_.next])) {
            blame(reason, Activity::StalledRequests);
            break;
        }
        late_.count_look_up();
    }
    if (late_walk_.next < lines.size()) return late_walk_.next > before;
    if (const auto behind = interlock_.enter(token.quad())) late_.wait_behind(*behind);
    late_.park(token, late_walk_.end());
    ports_.late_in.pop();
    return true;
}

void DepthTiming::store_pixels(const QuadToken& token) {
    const PreparedDraw& draw = token.draw();
    const auto lines = token.part->work.depth_lines(token.quad());
    for (std::size_t i = 0; draw.writes_depth && i < lines.size(); ++i)
        ports_.cache.write_memory(lines[i], written_bytes(Path::Late, token, i).touched);
    interlock_.store(now() + config_.depth_cache.store_cycles);
}

Cycle DepthTiming::next_work(Activity last) const {
    return interlock_.changes() ? now() + 1 : Unit::next_work(last);
}

} // namespace ffgpu::timing
