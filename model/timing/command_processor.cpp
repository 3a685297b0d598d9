#include "model/timing/command_processor.h"

#include <algorithm>
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
    if (state_cycles_left_ > 0) {
        if (--state_cycles_left_ == 0 && requests_.empty()) end_transfer();
        return Activity::Busy;
    }
    if (!requests_.empty()) return move_lines();
    if (!image_.empty()) return read_image();
    if (!ports_.commands_in.can_pop()) return Activity::Idle;
    const CommandToken& command = ports_.commands_in.front();
    if (const auto* const token = std::get_if<DrawToken>(&command)) return draw(*token);
    if (!in_flight_.was_empty()) return Activity::StalledOutput;
    if (const auto* const end = std::get_if<DrainCommand>(&command)) return drain(*end);
    if (const auto* const told = std::get_if<ContentCommand>(&command)) return take_content(**told);
    if (const auto* const lines = std::get_if<HostAccessCommand>(&command))
        return let_host_access(**lines);
    return begin(*std::get<std::shared_ptr<TransferCommand>>(command));
}

// What an image reads is asked for while the picture is drawn; the next command waits for that.
// Draws of a tile-based machine's scene leave the pipe together: its first alone can wait for that.
Activity CommandProcessor::draw(const DrawToken& draw) {
    const bool begins_scene = draw.draw == 0;
    if (config_.command_processor.drains && begins_scene && !decoding_ && !in_flight_.was_empty())
        return Activity::StalledOutput;
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
    if (transfer.kind == WorkKind::Clear) {
        clear(transfer);
    } else {
        for (const work::TransferLine& part : transfer.lines)
            part.write ? overwrite(part) : read(part);
    }
    if (requests_.empty() && state_cycles_left_ == 0) end_transfer();
    return Activity::Busy;
}

void CommandProcessor::clear(const work::PreparedTransfer& transfer) {
    for (BlockStates* const blocks : {ports_.depth_blocks, ports_.color_blocks})
        if (blocks) blocks->begin_clear(transfer);
    std::uint64_t states = 0;
    for (const work::TransferLine& part : transfer.lines) {
        if (clear_state(part)) {
            ++states;
        } else {
            overwrite(part);
        }
    }
    for (BlockStates* const blocks : {ports_.depth_blocks, ports_.color_blocks}) {
        if (!blocks) continue;
        blocks->end_clear(transfer);
        state_cycles_left_ = std::max(state_cycles_left_, blocks->clear_cycles(states));
    }
}

// A line whose state says it all is not written, and what the cache has of it is of no use.
bool CommandProcessor::clear_state(const work::TransferLine& part) {
    BlockStates* const blocks = blocks_of(part);
    if (!blocks || !blocks->clear_fast(part)) return false;
    cache_of(part).overwrite(part.line.number, LineAccess::Whole);
    return true;
}

void CommandProcessor::read(const work::TransferLine& part) {
    LineCache& cache = cache_of(part);
    const BlockStates* const blocks = blocks_of(part);
    const std::uint64_t number = part.line.number;
    const std::uint32_t bytes = blocks ? blocks->stored_bytes(number) : cache.line_bytes();
    if (bytes > 0) read(cache, number, bytes);
}

// Writes a line past the cache, which forgets it. Bytes of which only some bits are written are
// read before. Where some of a line stays that does not lie in memory as it is, all of it is read
// and written.
void CommandProcessor::overwrite(const work::TransferLine& part) {
    LineCache& cache = cache_of(part);
    const work::WrittenLine& line = part.line;
    write_back(cache, cache.overwrite(line.number, line.bytes.covered));
    const bool whole = line.bytes.covered == cache.grain().all();
    if (resolve(part, whole ? BlockStates::Change::Whole : BlockStates::Change::Part)) return;
    if (line.bytes.touched != line.bytes.covered) read(cache, line.number, cache.line_bytes());
    requests_.push_back({.address = line.number * cache.line_bytes(),
                         .bytes = cache.moved_bytes(line.bytes.touched),
                         .write = true,
                         .client = Client::Command});
}

// The line lies in memory as it is from now on. True: it did not, and is written whole.
bool CommandProcessor::resolve(const work::TransferLine& part, BlockStates::Change change) {
    BlockStates* const blocks = blocks_of(part);
    if (!blocks) return false;
    const LineCache& cache = cache_of(part);
    const std::uint64_t number = part.line.number;
    const std::uint32_t bytes = blocks->stored_bytes(number);
    if (!blocks->make_plain(number, change)) return false;
    if (bytes > 0) read(cache, number, bytes);
    requests_.push_back({.address = number * cache.line_bytes(),
                         .bytes = cache.line_bytes(),
                         .write = true,
                         .client = Client::Command});
    return true;
}

Activity CommandProcessor::take_content(const work::PreparedContent& content) {
    BlockStates* const blocks = content.depth ? ports_.depth_blocks : ports_.color_blocks;
    if (blocks) blocks->content(content);
    ports_.commands_in.pop();
    return Activity::Busy;
}

// The host sees memory as it is: its lines are written back and made plain.
Activity CommandProcessor::let_host_access(const std::vector<work::TransferLine>& lines) {
    for (const work::TransferLine& part : lines) {
        BlockStates* const blocks = blocks_of(part);
        if (!blocks) continue;
        LineCache& cache = cache_of(part);
        write_back(cache, cache.overwrite(part.line.number, 0));
        resolve(part, BlockStates::Change::Part);
        if (part.write) blocks->forget(part.line.number);
    }
    ports_.commands_in.pop();
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

void CommandProcessor::read(const LineCache& cache, std::uint64_t line, std::uint32_t bytes) {
    requests_.push_back({.address = line * cache.line_bytes(),
                         .bytes = bytes,
                         .write = false,
                         .client = Client::Command});
}

void CommandProcessor::write_back(const LineCache& cache, const LineWrite& line) {
    if (line.bytes == 0) return;
    MemoryRequest request{.address = line.number * cache.line_bytes(),
                          .bytes = line.read_bytes,
                          .write = false,
                          .client = cache.client()};
    if (line.read_bytes > 0) requests_.push_back(request);
    request.bytes = line.bytes;
    request.write = true;
    requests_.push_back(request);
}

void CommandProcessor::write_back(LineCache& cache) {
    for (const LineWrite& line : cache.flush())
        write_back(cache, line);
}

// One at least.
Activity CommandProcessor::move_lines() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    for (std::uint32_t i = 0; i < config_.command_processor.lines_per_cycle; ++i) {
        if (requests_.empty() || !ports_.requests_out.can_push()) break;
        ports_.requests_out.push(requests_.front());
        requests_.pop_front();
    }
    if (requests_.empty() && transferring_) end_transfer();
    return Activity::Busy;
}

Activity CommandProcessor::read_image() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    for (std::uint32_t i = 0; i < config_.command_processor.lines_per_cycle; ++i) {
        if (image_.empty() || !ports_.requests_out.can_push()) break;
        ports_.requests_out.push({.address = image_.address(),
                                  .bytes = image_.bytes(config_.host.burst_bytes),
                                  .write = false,
                                  .client = Client::Command});
        image_.advance(config_.host.burst_bytes);
    }
    return Activity::Busy;
}

} // namespace ffgpu::timing
