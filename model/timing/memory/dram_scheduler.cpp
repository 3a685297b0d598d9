#include "model/timing/memory/dram_scheduler.h"

#include <algorithm>
#include <array>

namespace ffgpu::timing {
namespace {

constexpr MemoryCycle Never = ~MemoryCycle{0};

std::uint64_t bit(std::uint32_t bank) {
    return std::uint64_t{1} << bank;
}

} // namespace

struct DramScheduler::Search {
    const std::vector<WaitingRequest>& waiting;
    const DramDevice& device;
    MemoryCycle now;
    std::uint64_t hits = 0;     // banks whose open row somebody waits for
    bool order_forbids = false; // a younger one's data could flow
    // Banks of which a column was looked at: [to write]. All columns of a kind in an open row are
    // ready at one time.
    std::array<std::uint64_t, 2> looked_at{};
    DramCommand command{.again_at = Never};

    bool is_hit(const DramRequest& request) const {
        return device.open_row(request.bank) == request.row;
    }
    // A candidate: taken if its time has come. The oldest candidate names the cause of the wait.
    bool consider(DramCommand::Kind kind, std::size_t index, const Ready& ready) {
        if (ready.at <= now) {
            command = {.kind = kind, .index = index};
            return true;
        }
        if (ready.at < command.again_at) command.again_at = ready.at;
        return false;
    }
};

// The oldest request may always go; a younger one only while the oldest may be passed. Requests
// that have been passed as often as they may are the oldest ones: who passes one passes all before.
void DramScheduler::find_column(Search& search) const {
    const bool may_pass = search.waiting.front().passed < limit_;
    for (std::size_t i = 0; i < search.waiting.size(); ++i) {
        const DramRequest& request = search.waiting[i].request;
        if (!search.is_hit(request)) continue;
        search.hits |= bit(request.bank);
        std::uint64_t& looked_at = search.looked_at[request.write];
        if ((looked_at & bit(request.bank)) != 0) continue;
        looked_at |= bit(request.bank);
        const Ready ready = search.device.column_ready(request);
        if (i == 0 || may_pass) {
            if (search.consider(DramCommand::Kind::Column, i, ready)) return;
        } else if (ready.at <= search.now) {
            search.order_forbids = true;
        } else {
            search.command.again_at = std::min(search.command.again_at, ready.at); // a new cause
        }
    }
}

// A bank works for the oldest request that needs it, and leaves its row only when nobody waits for
// that any more, or when the request has been passed too often.
void DramScheduler::find_row(Search& search) const {
    std::uint64_t claimed = 0;
    for (std::size_t i = 0; i < search.waiting.size(); ++i) {
        const DramRequest& request = search.waiting[i].request;
        const std::uint64_t bank = bit(request.bank);
        if ((claimed & bank) != 0) continue;
        claimed |= bank;
        if (search.is_hit(request)) continue;
        if (search.device.open_row(request.bank) == DramDevice::NoRow) {
            const Ready ready = search.device.activate_ready(request.bank);
            if (search.consider(DramCommand::Kind::Activate, i, ready)) return;
        } else if ((search.hits & bank) == 0 || search.waiting[i].passed >= limit_) {
            const Ready ready = search.device.precharge_ready(request.bank);
            if (search.consider(DramCommand::Kind::Precharge, i, ready)) return;
        }
    }
}

// Data do not flow because of the oldest request: what it waits for, or waited for until now.
LostTo DramScheduler::why_oldest_waits(const Search& search) {
    const DramRequest& oldest = search.waiting.front().request;
    const DramDevice& device = search.device;
    const Ready ready = search.is_hit(oldest) ? device.column_ready(oldest)
                        : device.open_row(oldest.bank) == DramDevice::NoRow
                            ? device.activate_ready(oldest.bank)
                            : device.precharge_ready(oldest.bank);
    return ready.at < search.now ? LostTo::Row : ready.cause;
}

DramCommand DramScheduler::choose(const std::vector<WaitingRequest>& waiting,
                                  const DramDevice& device,
                                  MemoryCycle now) const {
    if (waiting.empty()) return {.again_at = Never};
    Search search{waiting, device, now};
    find_column(search);
    if (search.command.kind == DramCommand::Kind::None) find_row(search);
    if (search.command.kind == DramCommand::Kind::Column) return search.command;

    search.command.cause = why_oldest_waits(search);
    if (search.order_forbids && search.command.cause != LostTo::Turnaround)
        search.command.cause = LostTo::Order;
    return search.command;
}

void DramScheduler::remove(std::vector<WaitingRequest>& waiting, std::size_t index) {
    for (std::size_t i = 0; i < index; ++i)
        ++waiting[i].passed;
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(index));
}

} // namespace ffgpu::timing
