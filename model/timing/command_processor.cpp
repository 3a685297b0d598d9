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
    , memory_in_flight_(memory_in_flight) {
    in_flight.connect(*this);
    memory_in_flight.connect(*this);
}

void CommandProcessor::enqueue(TimedScene& scene) {
    for (std::uint32_t i = 0; i < scene.work.draws.size(); ++i)
        commands_.push_back(DrawToken{&scene, i});
    wake();
}

void CommandProcessor::enqueue(work::PreparedTransfer&& transfer) {
    const CommandKind kind =
        transfer.kind == WorkKind::Clear ? CommandKind::Clear : CommandKind::Copy;
    const std::size_t entry = ports_.ledger.open(kind, transfer.number, 1);
    commands_.push_back(Transfer{std::move(transfer), entry});
    wake();
}

void CommandProcessor::enqueue_frame_end() {
    commands_.push_back(FrameEnd{});
    wake();
}

Activity CommandProcessor::step() {
    while (ports_.responses_in.can_pop())
        ports_.responses_in.pop(); // Data of copies: only their time matters.
    if (!requests_.empty()) return move_line();
    if (commands_.empty()) return Activity::Idle;
    const Command& command = commands_.front();
    if (const auto* const token = std::get_if<DrawToken>(&command)) return draw(*token);
    if (!in_flight_.was_empty()) return Activity::StalledOutput;
    if (const auto* const transfer = std::get_if<Transfer>(&command)) return begin(transfer->work);
    return end_frame();
}

Activity CommandProcessor::draw(const DrawToken& draw) {
    if (!decoding_) {
        decoding_ = true;
        decoded_at_ = now() + config_.command_processor.draw_cycles - 1;
    }
    if (now() < decoded_at_) return Activity::Busy;
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
    for (const work::TransferLine& part : transfer.lines) {
        LineCache& cache = part.depth ? ports_.depth_cache : ports_.color_cache;
        part.write ? overwrite(cache, part.line) : read(cache, part.line.number);
    }
    if (requests_.empty()) end_transfer();
    return Activity::Busy;
}

// Its last line has left, or it has none.
void CommandProcessor::end_transfer() {
    ports_.ledger.end_part(std::get<Transfer>(commands_.front()).entry, now());
    commands_.pop_front();
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

void CommandProcessor::read(const LineCache& cache, std::uint64_t line) {
    requests_.push_back({.address = line * cache.line_bytes(),
                         .bytes = cache.line_bytes(),
                         .write = false,
                         .client = Client::Command});
}

void CommandProcessor::write_back(const LineCache& cache, const LineWrite& line) {
    if (line.bytes == 0) return;
    requests_.push_back({.address = line.number * cache.line_bytes(),
                         .bytes = line.bytes,
                         .write = true,
                         .client = cache.client()});
}

void CommandProcessor::write_back(LineCache& cache) {
    for (const LineWrite& line : cache.flush())
        write_back(cache, line);
}

// Writes a line past the cache, which forgets it. Bytes of which only some bits are written are
// read before.
void CommandProcessor::overwrite(LineCache& cache, const work::WrittenLine& line) {
    write_back(cache, cache.overwrite(line.number, line.bytes.covered));
    if (line.bytes.touched != line.bytes.covered) read(cache, line.number);
    requests_.push_back({.address = line.number * cache.line_bytes(),
                         .bytes = cache.moved_bytes(line.bytes.touched),
                         .write = true,
                         .client = Client::Command});
}

Activity CommandProcessor::move_line() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    ports_.requests_out.push(requests_.front());
    requests_.pop_front();
    if (requests_.empty() && std::holds_alternative<Transfer>(commands_.front())) end_transfer();
    return Activity::Busy;
}

} // namespace ffgpu::timing
