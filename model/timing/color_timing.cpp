#include "model/timing/color_timing.h"

namespace ffgpu::timing {

ColorTiming::ColorTiming(sc_core::sc_module_name name,
                         const Clock& clock,
                         const TimingConfig& config,
                         const Ports& ports,
                         InFlight& in_flight,
                         std::function<void(const QuadToken&, Cycle)> on_retire)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , in_flight_(in_flight)
    , on_retire_(std::move(on_retire))
    , parked_(config.color_cache.fragment_fifo * config.raster.quads_per_cycle)
    , interlock_(config.color_cache.fragment_fifo) {
    go_on_while_busy();
}

// Without a cache: of every quad, whatever of it is changed.
bool ColorTiming::read_pixels(Activity& reason) {
    const QuadToken& token = ports_.quads_in.front();
    if (!interlock_.admits(token.quad())) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const auto lines = token.part->work.color_lines(token.quad());
    if (!lines.empty() && !walk_.read(ports_.cache, lines[walk_.next])) {
        blame(reason, Activity::StalledRequests);
        return false;
    }
    parked_.count_look_up();
    if (walk_.next < lines.size()) return true;
    if (const auto behind = interlock_.enter(token.quad())) parked_.wait_behind(*behind);
    parked_.park(ports_.quads_in.pop(), walk_.end());
    return true;
}

void ColorTiming::store_pixels(const QuadToken& token) {
    const work::PreparedQuads& work = token.part->work;
    const auto lines = work.color_lines(token.quad());
    for (std::size_t i = 0; token.draw().writes_color && i < lines.size(); ++i)
        ports_.cache.write_memory(lines[i], work.color_bytes(token.quad(), i).touched);
    interlock_.store(now() + config_.color_cache.store_cycles);
}

Cycle ColorTiming::next_work(Activity last) const {
    return interlock_.changes() ? now() + 1 : Unit::next_work(last);
}

bool ColorTiming::look_up(Activity& reason) {
    if (!ports_.quads_in.can_pop()) return false;
    if (!ports_.cache.is_enabled()) return read_pixels(reason);
    if (parked_.is_full()) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const QuadToken& token = ports_.quads_in.front();
    const PreparedDraw& draw = token.draw();
    const auto lines = token.part->work.color_lines(token.quad());
    if (draw.writes_color && !lines.empty()) {
        const std::uint64_t line = lines[walk_.next];
        const work::WrittenBytes& written = token.part->work.color_bytes(token.quad(), walk_.next);
        if (!walk_.look_up(ports_.cache,
                           {.number = line,
                            .read = draw.reads_color ? written.touched : 0,
                            .written = written.touched,
                            .covered = written.covered})) {
            blame(reason, Activity::StalledRequests);
            return false;
        }
        parked_.count_look_up();
        if (observer_) observer_->color_line(name_of(token), {line, walk_.missed, now()});
        if (ports_.blocks && draw.has_values) follow_values(token, line);
        if (walk_.next < lines.size()) return true;
    }
    parked_.park(ports_.quads_in.pop(), walk_.end());
    return true;
}

void ColorTiming::follow_values(const QuadToken& token, std::uint64_t line) {
    const PreparedDraw& draw = token.draw();
    const QuadValues values = token.values();
    for (std::size_t i = 0; i < draw.color_places.size(); ++i)
        ports_.blocks->write(
            draw.color_places[i], token.quad(), values.colors[draw.color_targets[i]], line);
}

bool ColorTiming::retire(Activity& reason) {
    if (parked_.empty()) return false;
    if (!parked_.front_has_data(ports_.cache)) {
        blame(reason, Activity::StalledMemory);
        return false;
    }
    const QuadToken token = parked_.pop();
    if (!ports_.cache.is_enabled()) store_pixels(token);
    on_retire_(token, now());
    token.scene().retire_quad(token, now());
    in_flight_.leave();
    return true;
}

Activity ColorTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    interlock_.begin_cycle(now());
    Activity reason = Activity::Idle;
    bool worked = false;
    for (std::uint32_t i = 0; i < config_.raster.quads_per_cycle && retire(reason); ++i)
        worked = true;
    const std::uint32_t lookups =
        config_.color_cache.lookups_per_cycle * config_.raster.quads_per_cycle;
    std::uint32_t looked_up = 0;
    for (; looked_up < lookups && look_up(reason); ++looked_up)
        worked = true;
    if (walk_.lacks_port) parked_.count_look_up(lookups - looked_up); // It takes all the cycle.
    if (interlock_.changes()) blame(reason, Activity::StalledMemory); // Stores are under way.
    if (!worked) return reason;
    if ((parked_.is_full() || !ports_.quads_in.can_pop()) && parked_.rests(ports_.cache) &&
        ports_.cache.rests() && !interlock_.changes())
        rest_as(parked_.empty() ? Activity::Idle : Activity::StalledMemory);
    return Activity::Busy;
}

} // namespace ffgpu::timing
