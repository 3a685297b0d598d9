#include "model/timing/memory_arbiter.h"

#include <bit>
#include <utility>

namespace ffgpu::timing {

MemoryArbiter::MemoryArbiter(sc_core::sc_module_name name,
                             const Clock& clock,
                             const MemoryConfig& config,
                             Ports ports,
                             InFlight& in_flight)
    : Unit(name, clock)
    , mapping_(config)
    , channels_(config.channels)
    , ports_(std::move(ports))
    , in_flight_(in_flight)
    , pending_(config.channels, nullptr)
    , taken_at_(config.channels, 0) {
    check(ports_.requests_in.size() < 64, "a bit for each port");
    socket.register_nb_transport_bw(this, &MemoryArbiter::on_backward);
    go_on_while_busy();
}

// Rounds over the ports, from the one whose turn it is: each sends one in a round.
Activity MemoryArbiter::step() {
    const Cycle cycle = now();
    std::uint64_t wanting = 0; // ports with a request, a bit each
    const Channel<MemoryRequest>* const* const requests_in = ports_.requests_in.data();
    for (std::size_t port = ports_.requests_in.size(); port-- > 0;)
        wanting = wanting << 1 | std::uint64_t{requests_in[port]->arrival() <= cycle};
    std::uint32_t left = channels_;
    for (std::uint32_t sent = 1; sent > 0 && left > 0 && wanting != 0; left -= sent) {
        const bool is_one = (wanting & (wanting - 1)) == 0;
        sent = is_one ? send_of_one(wanting, left) : send_round(wanting, left);
    }
    if (left < channels_) {
        if (wanting == 0) rest_as(Activity::Idle);
        return Activity::Busy;
    }
    return wanting != 0 ? Activity::StalledOutput : Activity::Idle;
}

// Rounds where one port alone has requests.
inline std::uint32_t MemoryArbiter::send_of_one(std::uint64_t& wanting, std::uint32_t most) {
    const auto port = static_cast<std::size_t>(std::countr_zero(wanting));
    const Channel<MemoryRequest>& requests = *ports_.requests_in[port];
    std::uint32_t sent = 0;
    for (; sent < most && wanting != 0; ++sent) {
        const std::uint32_t channel = mapping_.channel(requests.front().address);
        if (!is_free(channel)) break;
        send(port, channel);
        if (!requests.can_pop()) wanting = 0;
    }
    if (sent > 0) next_port_ = port + 1 < ports_.requests_in.size() ? port + 1 : 0;
    return sent;
}

inline std::uint32_t MemoryArbiter::send_round(std::uint64_t& wanting, std::uint32_t most) {
    const std::size_t ports = ports_.requests_in.size();
    std::uint32_t sent = 0;
    const std::uint64_t before = (std::uint64_t{1} << next_port_) - 1;
    std::uint64_t turn = wanting & ~before, then = wanting & before;
    if (turn == 0) turn = std::exchange(then, 0);
    while (turn != 0 && sent < most) {
        const std::uint64_t it = turn & -turn;
        const auto port = static_cast<std::size_t>(std::countr_zero(turn));
        turn ^= it;
        if (turn == 0) turn = std::exchange(then, 0);
        const Channel<MemoryRequest>& requests = *ports_.requests_in[port];
        const std::uint32_t channel = mapping_.channel(requests.front().address);
        if (!is_free(channel)) continue;
        send(port, channel);
        if (!requests.can_pop()) wanting ^= it;
        next_port_ = port + 1 < ports ? port + 1 : 0;
        ++sent;
    }
    return sent;
}

[[gnu::always_inline]] inline void MemoryArbiter::send(std::size_t port, std::uint32_t channel) {
    Channel<MemoryRequest>& requests = *ports_.requests_in[port];
    RequestTag& tag = pool_.acquire(requests.front(), port, requests.popped());
    requests.drop();
    check(mapping_.is_in_one_place(tag.request.address, tag.request.bytes),
          "a request across an interleave or a row");
    if (observer_) observer_->sent(tag.request, now());
    pending_[channel] = &tag;
    if (direct_ ? direct_->take(tag, channel) : send_by_socket(tag)) pending_[channel] = nullptr;
}

bool MemoryArbiter::send_by_socket(const RequestTag& tag) {
    tlm::tlm_phase phase = tlm::BEGIN_REQ;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    tlm::tlm_generic_payload& payload = PayloadPool::filled_in(tag);
    return socket->nb_transport_fw(payload, phase, delay) == tlm::TLM_UPDATED;
}

tlm::tlm_sync_enum MemoryArbiter::on_backward(tlm::tlm_generic_payload& payload,
                                              tlm::tlm_phase& phase,
                                              sc_core::sc_time&) {
    RequestTag& tag = *payload.get_extension<RequestTag>();
    if (phase == tlm::END_REQ) {
        taken(tag);
        return tlm::TLM_ACCEPTED;
    }
    done(tag);
    return tlm::TLM_COMPLETED;
}

void MemoryArbiter::taken(const RequestTag& tag) {
    const std::uint32_t channel = mapping_.channel(tag.request.address);
    pending_[channel] = nullptr;
    taken_at_[channel] = now();
    wake();
}

void MemoryArbiter::done(RequestTag& tag) {
    const MemoryRequest& request = tag.request;
    const Cycle cycle = now();
    if (counts_) statistics_.on_done(request, cycle);
    if (ledger_) ledger_->moved(request, cycle);
    if (waits_) waits_->done(request, cycle);
    if (observer_) observer_->done(request, cycle);
    if (!request.write) ports_.responses_out[request.port]->push(request.ticket);
    if (request.client != Client::ScanOut) in_flight_.leave(); // No frame waits for the screen.
    direct_ ? pool_.give_back(tag) : tag.payload->release();
}

} // namespace ffgpu::timing
