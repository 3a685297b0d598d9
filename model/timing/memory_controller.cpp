#include "model/timing/memory_controller.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

namespace {

DramRequest to_dram(const AddressMapping& mapping, const MemoryRequest& request, void* payload) {
    const DramPlace place = mapping.place(request.address);
    return {.bank = place.bank,
            .row = place.row,
            .offset = static_cast<std::uint32_t>(mapping.row_offset(request.address)),
            .bytes = request.bytes,
            .write = request.write,
            .client = static_cast<std::uint32_t>(request.client),
            .payload = payload};
}

} // namespace

DramRequest to_dram(const MemoryConfig& config, tlm::tlm_generic_payload& payload) {
    const MemoryRequest& request = payload.get_extension<RequestTag>()->request;
    return to_dram(AddressMapping(config), request, &payload);
}

MemoryController::MemoryController(sc_core::sc_module_name name,
                                   const Clock& clock,
                                   const MemoryConfig& config,
                                   std::size_t arrivals)
    : Unit(name, clock)
    , config_(config)
    , mapping_(config)
    , statistics_(config_, true)
    , lanes_(config.channels) {
    const Cycle there = 1 + config.latency / 2;
    for (std::uint32_t number = 0; number < config.channels; ++number) {
        lanes_[number].arrivals = std::make_unique<Channel<RequestTag*>>(
            clock, config.queue + (arrivals > 0 ? arrivals : there), there);
        lanes_[number].dram = std::make_unique<DramChannel>(
            config_, number, statistics_, clock.pace() == Pace::EveryCycle);
        lanes_[number].dram->tell_when_asked();
    }
    socket_.register_nb_transport_fw(this, &MemoryController::on_forward);
}

void MemoryController::connect(Unit& arbiter) {
    for (std::size_t number = 0; number < lanes_.size(); ++number)
        lanes_[number].arrivals->connect(
            "memory_channel" + std::to_string(number) + "_arrivals", arbiter, *this);
}

// Nor does the unit account for the cycles in which a bus carries data.
void MemoryController::leave_out_figures() {
    counts_ = false;
    for (Lane& lane : lanes_)
        lane.dram->leave_out_figures();
}

void MemoryController::set_command_observer(DramCommandObserver* observer) {
    commands_are_observed_ = observer != nullptr;
    for (Lane& lane : lanes_)
        lane.dram->set_command_observer(observer);
}

tlm::tlm_sync_enum MemoryController::on_forward(tlm::tlm_generic_payload& payload,
                                                tlm::tlm_phase& phase,
                                                sc_core::sc_time&) {
    check(phase == tlm::BEGIN_REQ, "the arbiter only begins requests");
    RequestTag& request = *payload.get_extension<RequestTag>();
    request.payload = &payload; // where the client has made the tag
    if (!take(request, mapping_.channel(payload.get_address()))) return tlm::TLM_ACCEPTED;
    phase = tlm::END_REQ;
    return tlm::TLM_UPDATED;
}

bool MemoryController::take(RequestTag& request, std::uint32_t channel) {
    Lane& lane = lanes_[channel];
    if (!lane.arrivals->can_push()) {
        lane.refused = &request;
        look_at_arrival(lane, now() + 1);
        wake();
        return false;
    }
    lane.arrivals->push(&request);
    if (lane.looks_at_arrivals()) look_at_arrival(lane, lane.arrivals->arrival());
    return true;
}

inline void MemoryController::look_at_arrival(Lane& lane, Cycle at) {
    lane.arrival_at = std::min(lane.arrival_at, at);
    lane.due = std::min(lane.due, at);
    next_work_ = std::min(next_work_, at);
}

void MemoryController::start(Lane& lane, MemoryCycle at) {
    RequestTag* const request = lane.arrivals->front();
    lane.arrivals->drop();
    lane.dram->push(to_dram(mapping_, request->request, request), at);
}

// When a column has gone out all is known of its request: when the bus carries its data, and when
// the answer is back.
void MemoryController::answer(Lane& lane) {
    Ring<ServedRequest>& served = lane.dram->served();
    const bool tells = tells_carrying();
    for (; !served.empty(); served.pop_front()) {
        const auto& [request, data] = served.front();
        const Cycle last = core_time(data.end), at = last + way_back();
        if (tells) carry(lane, {std::max(core_time(data.begin + 1), now()), last});
        if (lane.responses.empty()) lane.answer_at = at;
        lane.responses.push_back({at, static_cast<RequestTag*>(request.payload)});
    }
    if (tells) note_carrying(lane);
}

void MemoryController::carry(Lane& lane, const Carrying& carrying) {
    if (lane.carryings.empty() || lane.carryings.back().last + 1 < carrying.first)
        lane.carryings.push_back(carrying);
    else
        lane.carryings.back().last = carrying.last;
}

void MemoryController::accept_arrivals(Lane& lane, MemoryCycle at) {
    const bool may_arrive = lane.arrivals->can_pop() && lane.dram->has_room();
    if (!may_arrive && lane.arrivals->is_full()) return;
    while (lane.arrivals->can_pop() && lane.dram->has_room())
        start(lane, at);
    if (lane.refused && lane.arrivals->can_push()) {
        RequestTag& request = *std::exchange(lane.refused, nullptr);
        lane.arrivals->push(&request);
        client_ ? client_->taken(request) : say(request, tlm::END_REQ);
    }
}

void MemoryController::deliver(Lane& lane) {
    while (lane.answer_at <= now()) {
        RequestTag& request = *lane.responses.front().request;
        lane.responses.pop_front();
        lane.answer_at = lane.responses.empty() ? Never : lane.responses.front().at;
        client_ ? client_->done(request) : say(request, tlm::BEGIN_RESP);
    }
}

// By the socket.
void MemoryController::say(RequestTag& request, tlm::tlm_phase phase) {
    if (phase == tlm::BEGIN_RESP) request.payload->set_response_status(tlm::TLM_OK_RESPONSE);
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket_->nb_transport_bw(*request.payload, phase, delay);
}

// The channel, and what comes to it. Refreshes of a channel that nobody waits for are made up for
// when somebody does.
inline void MemoryController::work(Lane& lane) {
    const Cycle cycle = now();
    DramChannel& dram = *lane.dram;
    const MemoryCycle begin = memory_time(cycle - 1);
    if (lane.command_at < cycle) dram.advance(begin); // What went by unseen.
    if (lane.arrival_at <= cycle) accept_arrivals(lane, begin);
    dram.advance(memory_time(cycle));
    if (!dram.served().empty()) answer(lane);
    look_ahead(lane);
}

inline void MemoryController::look_ahead(Lane& lane) {
    const DramChannel& dram = *lane.dram;
    const MemoryCycle next = dram.next_work();
    lane.command_at = next == NoCycle ? Never : core_time(next + 1);
    lane.column_at = dram.has_waiting() ? next_command(lane) : Never;
    lane.is_behind = !tells_carrying() && dram.has_waiting() && lane.column_at > lane.command_at;
    lane.arrival_at = std::max(next_arrival(lane), now() + 1);
}

inline void MemoryController::note_carrying(Lane& lane) {
    const Cycle cycle = now();
    while (!lane.carryings.empty() && lane.carryings.front().last < cycle)
        lane.carryings.pop_front();
    lane.moves = false;
    lane.carrying_at = Never;
    if (lane.carryings.empty()) return;
    const Carrying& carrying = lane.carryings.front();
    lane.moves = carrying.first <= cycle;
    lane.carrying_at = lane.moves ? carrying.last + 1 : carrying.first;
}

// Mostly one part alone is due.
inline void MemoryController::step(Lane& lane) {
    const Cycle cycle = now();
    if (std::min(lane.command_at, lane.arrival_at) <= cycle) work(lane);
    if (lane.carrying_at <= cycle) note_carrying(lane);
    if (lane.answer_at <= cycle) deliver(lane);
    lane.due = std::min({lane.column_at, lane.arrival_at, lane.carrying_at, lane.answer_at});
}

// Busy while a bus carries data; all else that it does for a request is a stall.
Activity MemoryController::step() {
    const Cycle cycle = now();
    if (cycle < next_work_) return activity_;
    Activity activity = Activity::Idle;
    Cycle next = Never;
    for (Lane& lane : lanes_) {
        if (lane.due <= cycle) step(lane);
        if (lane.moves)
            activity = Activity::Busy;
        else if (activity == Activity::Idle && lane.is_waiting())
            activity = Activity::StalledMemory;
        next = std::min(next, lane.due);
    }
    next_work_ = next;
    return activity_ = activity;
}

void MemoryController::settle() {
    Unit::settle();
    const MemoryCycle end = memory_time(now());
    for (Lane& lane : lanes_) {
        lane.dram->settle(end);
        look_at_arrival(lane, now() + 1); // There may be room.
    }
    statistics_.count_accesses();
    statistics_.set_bus_cycles(end * config_.channels);
}

std::vector<const StatisticsGroup*> MemoryController::statistics() const {
    for (const Lane& lane : lanes_)
        lane.dram->tell();
    statistics_.count_accesses();
    return {&statistics_};
}

// When the channel has to be looked at for its next command: in the cycle in which that goes out,
// if it is a column or all are observed; but where nobody asks what the bus does, and nothing waits
// for a place, it is enough to be there before an answer could be back. What went out until then is
// made up for, then or when something arrives.
inline Cycle MemoryController::next_command(const Lane& lane) const {
    if (commands_are_observed_) return lane.command_at;
    if (tells_carrying()) return core_time(lane.dram->next_column() + 1);
    if (lane.refused || lane.arrivals->can_pop()) return lane.command_at;
    const MemoryCycle least = std::min(config_.column_cycles, config_.write_column_cycles);
    return std::max(lane.command_at, core_time(lane.dram->next_work() + least + 1) + way_back());
}

inline Cycle MemoryController::next_arrival(const Lane& lane) const {
    if (lane.refused && !lane.arrivals->is_full()) return now() + 1;
    return lane.looks_at_arrivals() ? lane.arrivals->arrival() : Never;
}

} // namespace ffgpu::timing
