#include "model/timing/command_processor.h"

#include <utility>

namespace ffgpu::timing {

CommandProcessor::CommandProcessor(sc_core::sc_module_name name,
                                   const Clock& clock,
                                   const TimingConfig& config,
                                   const Ports& ports,
                                   InFlight& in_flight,
                                   InFlight& memory_in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , in_flight_(in_flight)
    , memory_in_flight_(memory_in_flight) {}

void CommandProcessor::enqueue(TimedScene& scene) {
    for (std::uint32_t i = 0; i < scene.work.draws.size(); ++i)
        commands_.push_back(DrawToken{&scene, i});
}

void CommandProcessor::enqueue(work::PreparedTransfer&& transfer) {
    commands_.push_back(std::move(transfer));
}

void CommandProcessor::enqueue_frame_end() {
    commands_.push_back(FrameEnd{});
}

Activity CommandProcessor::step() {
    while (ports_.responses_in.can_pop())
        ports_.responses_in.pop(); // Data of copies: only their time matters.
    if (!transfers_.empty()) return move_line();
    if (commands_.empty()) return Activity::Idle;
    const Command& command = commands_.front();
    if (const auto* const token = std::get_if<DrawToken>(&command)) return draw(*token);
    if (!in_flight_.was_empty()) return Activity::StalledOutput;
    if (const auto* const transfer = std::get_if<work::PreparedTransfer>(&command))
        return begin(*transfer);
    return end_frame();
}

Activity CommandProcessor::draw(const DrawToken& draw) {
    if (!decoding_) {
        decoding_ = true;
        decode_cycles_left_ = config_.command_processor.draw_cycles - 1;
    }
    if (decode_cycles_left_ > 0) {
        --decode_cycles_left_;
        return Activity::Busy;
    }
    if (!ports_.draws_out.can_push()) return Activity::StalledOutput;
    in_flight_.enter();
    ports_.draws_out.push(draw);
    decoding_ = false;
    commands_.pop_front();
    return Activity::Busy;
}

Activity CommandProcessor::begin(const work::PreparedTransfer& transfer) {
    if (transfer.writes_back_caches) {
        write_back(ports_.color_cache);
        write_back(ports_.depth_cache);
    }
    for (const work::Discard& lines : transfer.discards)
        (lines.depth ? ports_.depth_cache : ports_.color_cache).discard(lines.begin, lines.end);
    for (const work::LineRange& lines : transfer.lines)
        transfers_.push_back({lines, Client::Command});
    commands_.pop_front();
    return Activity::Busy;
}

Activity CommandProcessor::end_frame() {
    if (!written_back_) {
        write_back(ports_.color_cache);
        write_back(ports_.depth_cache);
        written_back_ = true;
        return Activity::Busy;
    }
    if (!memory_in_flight_.was_empty()) return Activity::StalledMemory;
    written_back_ = false;
    commands_.pop_front();
    return Activity::Busy;
}

void CommandProcessor::write_back(LineCache& cache) {
    for (const std::uint64_t line : cache.flush())
        transfers_.push_back({{line, line + 1, cache.line_bytes(), true}, cache.client()});
}

Activity CommandProcessor::move_line() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    Transfer& transfer = transfers_.front();
    work::LineRange& lines = transfer.lines;
    if (lines.begin < lines.end) {
        ports_.requests_out.push({.address = lines.begin * lines.line_bytes,
                                  .bytes = lines.line_bytes,
                                  .write = lines.write,
                                  .client = transfer.client,
                                  .ticket = 0});
        ++lines.begin;
    }
    if (lines.begin == lines.end) transfers_.pop_front();
    return Activity::Busy;
}

} // namespace ffgpu::timing
