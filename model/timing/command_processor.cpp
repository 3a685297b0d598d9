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

void CommandProcessor::read(const LineCache& cache, std::uint64_t line) {
    transfers_.push_back({.address = line * cache.line_bytes(),
                          .bytes = cache.line_bytes(),
                          .write = false,
                          .client = Client::Command});
}

void CommandProcessor::write_back(const LineCache& cache, const LineWrite& line) {
    if (line.bytes == 0) return;
    transfers_.push_back({.address = line.number * cache.line_bytes(),
                          .bytes = line.bytes,
                          .write = true,
                          .client = cache.client()});
}

void CommandProcessor::write_back(LineCache& cache) {
    for (const LineWrite& line : cache.flush())
        write_back(cache, line);
}

// Writes lines past the cache, which forgets them. Bytes of which only some bits are written are
// read before.
void CommandProcessor::overwrite(LineCache& cache, const std::vector<WrittenLine>& lines) {
    for (const WrittenLine& line : lines) {
        write_back(cache, cache.overwrite(line.number, line.bytes.covered));
        if (line.bytes.touched != line.bytes.covered) read(cache, line.number);
        transfers_.push_back({.address = line.number * cache.line_bytes(),
                              .bytes = cache.moved_bytes(line.bytes.touched),
                              .write = true,
                              .client = Client::Command});
    }
}

void CommandProcessor::begin_clear(const WorkDraw& work) {
    if (!work.state) return;
    const Registers& state = *work.state;
    const Scissor& scissor = state.scissor;
    const Rectangle rectangle{
        scissor.x, scissor.y, scissor.x + scissor.width, scissor.y + scissor.height};
    const Surface& color = state.targets.color[0];
    if (work.clear.color && color.format != Format::None) {
        const PlacedLevel& place = addresses_.surface(color, config_.color_cache);
        overwrite(ports_.color_cache,
                  rectangle_lines(place,
                                  ports_.color_cache.grain(),
                                  rectangle,
                                  cleared_color_bytes(color.format, state.blend.write_mask)));
    }
    const Surface& depth = state.targets.depth;
    if ((work.clear.depth || work.clear.stencil) && depth.format != Format::None) {
        const PlacedLevel& place = addresses_.surface(depth, config_.depth_cache);
        const PixelBytes bytes =
            cleared_depth_bytes(depth.format, work.clear, state.stencil.front.write_mask);
        overwrite(ports_.depth_cache,
                  rectangle_lines(place, ports_.depth_cache.grain(), rectangle, bytes));
    }
}

void CommandProcessor::begin_copy(const WorkDraw& work) {
    write_back(ports_.color_cache);
    write_back(ports_.depth_cache);
    const CopyRectangleCommand& copy = work.copy;
    const bool is_depth = format_info(copy.source.format).is_depth;
    const CacheConfig& config =
        is_depth ? static_cast<const CacheConfig&>(config_.depth_cache) : config_.color_cache;
    LineCache& cache = is_depth ? ports_.depth_cache : ports_.color_cache;
    const auto lines = [&](const Surface& surface, int x, int y) {
        return rectangle_lines(addresses_.surface(surface, config),
                               cache.grain(),
                               {x, y, x + copy.width, y + copy.height},
                               whole_pixel(surface.format));
    };
    for (const WrittenLine& line : lines(copy.source, copy.source_x, copy.source_y))
        read(cache, line.number);
    overwrite(cache, lines(copy.destination, copy.destination_x, copy.destination_y));
    addresses_.memory_written(copy.destination.address, copy.destination.bytes());
}

Activity CommandProcessor::transfer() {
    if (!ports_.requests_out.can_push()) return Activity::StalledRequests;
    ports_.requests_out.push(transfers_.front());
    transfers_.pop_front();
    return Activity::Busy;
}

} // namespace ffgpu::timing
