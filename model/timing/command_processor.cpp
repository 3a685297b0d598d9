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

Activity CommandProcessor::step() {
    while (ports_.responses_in.can_pop())
        ports_.responses_in.pop(); // Data of copies and images: only their time matters.
    if (!requests_.empty()) return move_line();
    if (!image_.empty()) return read_image();
    if (!ports_.commands_in.can_pop()) return Activity::Idle;
    const CommandToken& command = ports_.commands_in.front();
    if (const auto* const token = std::get_if<DrawToken>(&command)) return draw(*token);
    if (!in_flight_.was_empty()) return Activity::StalledOutput;
    if (const auto* const end = std::get_if<DrainCommand>(&command)) return drain(*end);
    return begin(*std::get<std::shared_ptr<TransferCommand>>(command));
}

// What an image reads is asked for while the picture is drawn; the next command waits for that.
Activity CommandProcessor::draw(const DrawToken& draw) {
    if (!decoding_) {
        decoding_ = true;
        decoded_at_ = now() + config_.command_processor.draw_cycles - 1;
    }
    if (now() < decoded_at_) return Activity::Busy;
    if (!ports_.draws_out.can_push()) return Activity::StalledOutput;
    in_flight_.enter();
    ports_.draws_out.push(draw);
    const work::ImageMemory& image = draw.prepared().image;
    image_ = Bursts(image.address, image.row_bytes, image.stride, image.rows);
    decoding_ = false;
    ports_.commands_in.pop();
    return Activity::Busy;
}

Activity CommandProcessor::begin(TransferCommand& command) {
    const work::PreparedTransfer& transfer = command.work;
    transferring_ = true;
    if (transfer.writes_back_caches) {
        write_back(ports_.color_cache);
        write_back(ports_.depth_cache);
    }
    for (const work::PlacedLine& line : transfer.tile_lines)
        requests_.push_back({.address = line.address,
                             .bytes = line.bytes,
                             .write = true,
                             .client = line.depth ? Client::Depth : Client::Color});
    for (const work::TransferLine& part : transfer.lines) {
        LineCache& cache = part.depth ? ports_.depth_cache : ports_.color_cache;
        part.write ? overwrite(cache, part.line) : read(cache, part.line.number);
    }
    if (requests_.empty()) end_transfer();
    return Activity::Busy;
}

// Its last line has left, or it has none.
void CommandProcessor::end_transfer() {
    const CommandToken command = ports_.commands_in.pop();
    ports_.ledger.end_part(std::get<std::shared_ptr<TransferCommand>>(command)->entry, now());
    transferring_ = false;
}

Activity CommandProcessor::drain(const DrainCommand& drain) {
    if (!written_back_) {
        write_back(ports_.color_cache);
        write_back(ports_.depth_cache);
        written_back_ = true;
        return Activity::Busy;
    }
    if (drain.ends_frame && !memory_in_flight_.was_empty()) return Activity::StalledMemory;
    if (!ports_.drained_out.can_push()) return Activity::StalledOutput;
    ports_.drained_out.push({});
    written_back_ = false;
    ports_.commands_in.pop();
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
    if (requests_.empty() && transferring_) end_transfer();
    return Activity::Busy;
}

Activity CommandProcessor::read_image() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    ports_.requests_out.push({.address = image_.address(),
                              .bytes = image_.bytes(config_.host.burst_bytes),
                              .write = false,
                              .client = Client::Command});
    image_.advance(config_.host.burst_bytes);
    return Activity::Busy;
}

} // namespace ffgpu::timing
