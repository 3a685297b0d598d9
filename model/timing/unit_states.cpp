// What each unit says of itself where the machine is stuck: what it holds, what the first of it is,
// and how far it has come.

#include "model/timing/machine.h"
#include "model/timing/memory_controller.h"

#include <fmt/format.h>

namespace ffgpu::timing {
namespace {

std::string parked(const ParkedQuads& quads, const LineCache& cache) {
    if (quads.empty()) return "no quad parked";
    return fmt::format("{} quads parked, the first, {}, {}",
                       quads.size(),
                       quads.front().key(),
                       quads.front_has_data(cache)
                           ? "with its data"
                           : fmt::format("waits for fill {}", quads.front_ticket()));
}

} // namespace

std::string LineCache::state() const {
    return fmt::format("{} fills outstanding, the first incomplete is {} of {}; {} requests wait "
                       "for the request queue",
                       outstanding_,
                       first_incomplete_,
                       next_ticket_ - 1,
                       requests_.waiting());
}

std::string HostBus::state() const {
    if (commands_.empty()) return "nothing left to send";
    const Command& first = commands_.front();
    return fmt::format("{} commands to send; of the first, {}, {} bytes are to go over the bus",
                       commands_.size(),
                       first.data.bursts.empty() && arriving_ == 0 ? key_of(first.token) : "data",
                       first.bytes);
}

std::string CommandProcessor::state() const {
    return fmt::format("{} lines to move; {} in the pipe and {} of the memory are under way",
                       requests_.size(),
                       in_flight_.count(),
                       memory_in_flight_.count());
}

std::string VertexFetch::state() const {
    std::string text = fmt::format("{} vertices named, {} fetched", named_.size(), waiting_.size());
    const Waiting* const first = !waiting_.empty() ? &waiting_.front()
                                 : !named_.empty() ? &named_.front()
                                                   : nullptr;
    if (first)
        text +=
            fmt::format("; the first, {}, waits for fill {}", first->vertex.key(), first->ticket);
    return text + "; vertices: " + ports_.cache.state() +
           "; indices: " + ports_.index_cache.state();
}

std::string GeometryTiming::state() const {
    if (order_.empty()) return "no vertex";
    return fmt::format("{} vertices, the first, {}, done in cycle {}",
                       order_.size(),
                       order_.front().vertex.key(),
                       order_.front().done_at);
}

std::string ClipTiming::state() const {
    return working_ ? fmt::format("cuts the first primitive until cycle {}", clipped_at_)
                    : "no primitive begun";
}

std::string SetupTiming::state() const {
    if (units_.empty()) return "no piece";
    return fmt::format("{} pieces, the first, {}, done in cycle {}",
                       units_.size(),
                       units_.front().record.key(),
                       units_.front().done_at);
}

std::string TileBinner::state() const {
    return fmt::format("{}; {} writes to send; {} parameter buffers free; {}",
                       has_primitive_ ? "bins " + token_.key() : "no primitive",
                       writes_.size(),
                       free_buffers_.size(),
                       pass_ ? "fills " + pass_->token.key() : "no pass open");
}

std::string ParameterFetch::state() const {
    if (open_.empty()) return "no bin";
    const Open& first = open_.front();
    return fmt::format("{} bins, the first, {}: {} requests to send, {} on their way",
                       open_.size(),
                       first.token.key(),
                       first.requests.size(),
                       first.on_their_way);
}

std::string TileMemory::state() const {
    constexpr std::array<std::string_view, 3> States{"loads", "is drawn", "stores"};
    if (open_.empty()) return "no bin on chip";
    const Open& first = open_.front();
    return fmt::format("{} bins on chip, the first, {}, {}; {} lines on their way",
                       open_.size(),
                       first.token.key(),
                       States[static_cast<std::size_t>(first.state)],
                       first.on_their_way);
}

std::string RasterTiming::state() const {
    std::string walk = "no piece";
    if (piece_ != end_piece_)
        walk = fmt::format("piece {} of {}, walked in cycle {}", piece_, end_piece_, walked_at_);
    if (blocks_.empty()) return walk;
    const Block& first = blocks_.front();
    return fmt::format("{}; {} blocks, the first, with quad {}, in cycle {}",
                       walk,
                       blocks_.size(),
                       first.quad,
                       first.ready_at);
}

std::string DepthTiming::state() const {
    return fmt::format("early: {}; late: {}; {}",
                       parked(early_, ports_.cache),
                       parked(late_, ports_.cache),
                       ports_.cache.state());
}

std::string TexturePipe::state() const {
    std::string text = fmt::format("{} quads wait, {} parked", waiting_.size(), parked_.size());
    if (comparing_) text += ", looks up " + current_.key();
    if (!parked_.empty())
        text += fmt::format(
            ", the first, {}, of fill {}", parked_.front().quad.key(), parked_.front().ticket);
    return text;
}

std::string TextureTiming::state() const {
    std::string text;
    for (std::size_t pipe = 0; pipe < pipes_.size(); ++pipe)
        text += fmt::format("pipe {}: {}; ", pipe, pipes_[pipe].state());
    for (const CachePort* const port : ports_.caches)
        text += fmt::format(
            "{}{}: {}", port == ports_.caches[0] ? "" : "; ", port->name, port->cache.state());
    return text;
}

std::string TexelL2::state() const {
    std::string text;
    for (const Queue& queue : queues_) {
        text += fmt::format("{} requests wait", queue.waiting.size());
        if (!queue.waiting.empty())
            text += fmt::format(", the first for fill {}", queue.waiting.front().ticket);
        text += "; ";
    }
    return text + ports_.memory.cache.state();
}

std::string FragmentTiming::state() const {
    std::string text;
    for (std::size_t pipe = 0; pipe < pipes_.size(); ++pipe)
        text += fmt::format(
            "{}pipe {}: {} quads", pipe == 0 ? "" : "; ", pipe, pipes_[pipe].waiting.size());
    return text;
}

std::string ColorTiming::state() const {
    return parked(parked_, ports_.cache) + "; " + ports_.cache.state();
}

std::string ScanOut::state() const {
    return fmt::format("line {} of {}, {} reads outstanding", next_, surface_.lines, outstanding_);
}

std::string MemoryArbiter::state() const {
    std::size_t refused = 0;
    for (const RequestTag* const request : pending_)
        refused += request != nullptr;
    std::string text = fmt::format(
        "{} requests sent and not answered, {} of them not taken", pool_.used(), refused);
    if (const MemoryRequest* const first = pool_.first_used())
        text += fmt::format("; the oldest, a {}, of cycle {}", first->key(), first->issued);
    return text;
}

std::string MemoryController::state() const {
    std::string text;
    for (std::size_t number = 0; number < lanes_.size(); ++number) {
        const Lane& lane = lanes_[number];
        std::size_t carried = 0; // whose data are on the bus, or will be
        for (std::size_t i = 0; i < lane.responses.size(); ++i)
            carried += lane.responses[i].at > now() + way_back();
        text += fmt::format("{}channel {}: {} arrive, {} wait for a bank, {} on the bus, {} on "
                            "their way back",
                            number == 0 ? "" : "; ",
                            number,
                            lane.arrivals->items(),
                            lane.dram->waiting(),
                            carried,
                            lane.responses.size() - carried);
    }
    return text;
}

} // namespace ffgpu::timing
