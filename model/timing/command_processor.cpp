#include "model/timing/command_processor.h"

namespace ffgpu::timing {

CommandProcessor::CommandProcessor(sc_core::sc_module_name name,
                                   const Clock& clock,
                                   const TimingConfig& config,
                                   const Ports& ports,
                                   AddressMap& addresses,
                                   InFlight& in_flight,
                                   InFlight& memory_in_flight)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , addresses_(addresses)
    , in_flight_(in_flight)
    , memory_in_flight_(memory_in_flight) {}

void CommandProcessor::enqueue(PreparedBin& bin) {
    for (std::uint32_t i = 0; i < bin.draws.size(); ++i)
        commands_.push_back({{&bin, i}});
}

void CommandProcessor::enqueue_frame_end() {
    commands_.push_back({});
}

Activity CommandProcessor::step() {
    while (ports_.responses_in.can_pop())
        ports_.responses_in.pop(); // Data of copies: only their time matters.
    if (!transfers_.empty()) return transfer();
    if (commands_.empty()) return Activity::Idle;
    const Command& command = commands_.front();
    const bool streams = command.draw.bin && (command.draw.prepared().work.kind == WorkKind::Draw ||
                                              command.draw.prepared().work.kind == WorkKind::Image);
    return streams ? draw(command) : wait_then(command);
}

Activity CommandProcessor::draw(const Command& command) {
    const PreparedDraw& prepared = command.draw.prepared();
    if (!decoding_) {
        decoding_ = true; // A draw that the functional GPU split is one draw here.
        const bool continues = prepared.work.number == last_draw_number_;
        decode_cycles_left_ = continues ? 0 : config_.command_processor.draw_cycles - 1;
        last_draw_number_ = prepared.work.number;
    }
    if (decode_cycles_left_ > 0) {
        --decode_cycles_left_;
        return Activity::Busy;
    }
    if (!ports_.draws_out.can_push()) return Activity::StalledOutput;
    in_flight_.enter();
    ports_.draws_out.push(command.draw);
    decoding_ = false;
    commands_.pop_front();
    return Activity::Busy;
}

Activity CommandProcessor::wait_then(const Command& command) {
    if (!in_flight_.was_empty()) return Activity::StalledOutput;
    if (!command.draw.bin) {
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
    const WorkDraw work = command.draw.prepared().work;
    ++command.draw.bin->finished_draws;
    commands_.pop_front();
    work.kind == WorkKind::Clear ? begin_clear(work) : begin_copy(work);
    return Activity::Busy;
}

// The lines that `pixels` of a surface take, from its beginning: which lines does not matter, how
// many does.
void CommandProcessor::add_transfer(const PlacedLevel& surface,
                                    std::uint64_t pixels,
                                    std::uint32_t line_bytes,
                                    bool write) {
    const std::uint64_t bytes =
        std::min(pixels * surface.layout.element_bytes, surface.layer_bytes);
    const std::uint64_t first = surface.base / line_bytes;
    transfers_.push_back(
        {first, first + (bytes + line_bytes - 1) / line_bytes, line_bytes, write, Client::Command});
}

void CommandProcessor::write_back(LineCache& cache) {
    for (const std::uint64_t line : cache.flush())
        transfers_.push_back({line, line + 1, cache.line_bytes(), true, cache.client()});
}

void CommandProcessor::begin_clear(const WorkDraw& work) {
    if (!work.state) return;
    const Registers& state = *work.state;
    const std::uint64_t pixels = std::uint64_t{state.scissor.width} * state.scissor.height;
    const auto clear = [&](const Surface& target, const CacheConfig& cache, LineCache& lines) {
        if (target.format == Format::None) return;
        const PlacedLevel& place = addresses_.surface(target, cache);
        lines.discard(place.base, place.base + place.layer_bytes);
        add_transfer(place, pixels, cache.line_bytes, true);
    };
    if (work.clear.color) clear(state.targets.color[0], config_.color_cache, ports_.color_cache);
    if (work.clear.depth || work.clear.stencil)
        clear(state.targets.depth, config_.depth_cache, ports_.depth_cache);
}

void CommandProcessor::begin_copy(const WorkDraw& work) {
    write_back(ports_.color_cache);
    write_back(ports_.depth_cache);
    const std::uint64_t pixels = std::uint64_t{work.copy.width} * work.copy.height;
    const bool is_depth = format_info(work.copy.source.format).is_depth;
    const CacheConfig& cache =
        is_depth ? static_cast<const CacheConfig&>(config_.depth_cache) : config_.color_cache;
    add_transfer(addresses_.surface(work.copy.source, cache), pixels, cache.line_bytes, false);
    add_transfer(addresses_.surface(work.copy.destination, cache), pixels, cache.line_bytes, true);
    addresses_.memory_written(work.copy.destination.address, work.copy.destination.bytes());
}

Activity CommandProcessor::transfer() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    Transfer& transfer = transfers_.front();
    if (transfer.line < transfer.end) {
        ports_.requests_out.push({.address = transfer.line * transfer.line_bytes,
                                  .bytes = transfer.line_bytes,
                                  .write = transfer.write,
                                  .client = transfer.client,
                                  .ticket = 0});
        ++transfer.line;
    }
    if (transfer.line == transfer.end) transfers_.pop_front();
    return Activity::Busy;
}

} // namespace ffgpu::timing
