#include "model/timing/memory/dram_scheduler.h"

#include <algorithm>
#include <array>
#include <bit>

namespace ffgpu::timing {
namespace {

std::uint64_t bit(std::uint32_t bank) {
    return std::uint64_t{1} << bank;
}

} // namespace

struct DramScheduler::Search {
    const DramScheduler& scheduler;
    const WaitingRequests& waiting;
    const DramDevice& device;
    MemoryCycle now;
    DramCommand& command;
    MemoryCycle row_slot = device.free_slot(now); // for an activate or a precharge
    std::uint64_t hits = 0;                       // banks whose open row somebody waits for
    bool order_forbids = false;                   // a younger one's data could flow
    // Banks of which a column was looked at: [to write]. All columns of a kind in an open row are
    // ready at one time.
    std::array<std::uint64_t, 2> looked_at{};
    bool column_yields = false;  // its data could flow, but a bank's row went first
    std::uint32_t activates = 0; // of banks with older requests, which the next bank's comes behind
    // The next activate of a bank that could take it sooner, were it not for the others'.
    MemoryCycle held_activate_at = NoCycle;

    bool has_column() const { return command.kind == DramCommand::Kind::Column; }
    bool write_of(std::size_t index) const { return waiting[index].request.write; }
    bool is_hit(const DramRequest& request) const {
        return device.open_row(request.bank) == request.row;
    }
    // A candidate: taken if its time has come. The oldest candidate names the cause of the wait.
    bool consider(DramCommand::Kind kind, std::size_t index, MemoryCycle ready_at) {
        if (ready_at <= now) {
            command = {.kind = kind, .index = index};
            return true;
        }
        command.again_at = std::min(command.again_at, ready_at);
        return false;
    }
    // The same of a row.
    bool consider_row(DramCommand::Kind kind, std::size_t index, MemoryCycle ready_at) {
        return consider(kind, index, std::max(ready_at, row_slot));
    }
    bool consider_activate(std::size_t index, std::uint32_t bank) {
        const MemoryCycle ready_at = device.activate_ready_at(bank);
        if (device.is_activate_held(bank)) held_activate_at = ready_at;
        const bool could_go = ready_at <= now && row_slot <= now;
        if (could_go && scheduler.steps_back(bank, waiting, device, now)) return false;
        return consider_row(DramCommand::Kind::Activate, index, ready_at);
    }
    // A bank whose row is in the way. Where a column could go out, too, and the bank would be
    // closed in time a cycle later, the column does.
    bool consider_precharge(std::size_t index, MemoryCycle ready_at) {
        const MemoryCycle closed_at = now + 1 + device.precharge_cycles();
        if (has_column() && device.activate_waits_for(activates, closed_at)) return false;
        return consider_row(DramCommand::Kind::Precharge, index, ready_at);
    }
    // The column found goes a cycle later: one of its request's would take the slot of an activate
    // by whose distance from the one before all rows go. Then none does.
    void yield_to_held_activate() {
        if (!device.meets_where_activates_limit(
                waiting[command.index].request, now, held_activate_at))
            return;
        command = {.again_at = now + 1};
        column_yields = true;
    }
    void note_why() {
        command.column_yields = column_yields;
        command.order_forbids = order_forbids;
    }
    // The same of a column, which may go out of turn only where that `may_pass`.
    bool consider_column(std::size_t index, bool may_pass, MemoryCycle ready_at) {
        if (index == 0 || may_pass) return consider(DramCommand::Kind::Column, index, ready_at);
        if (ready_at <= now)
            order_forbids = true;
        else
            command.again_at = std::min(command.again_at, ready_at); // a new cause
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
        if (search.has_column()) continue;
        std::uint64_t& looked_at = search.looked_at[request.write];
        if ((looked_at & bit(request.bank)) != 0) continue;
        looked_at |= bit(request.bank);
        search.consider_column(i, may_pass, search.device.column_ready(request).at);
    }
}

// Whether more columns than the one found could go out but for the bus.
bool DramScheduler::is_bus_wanted(const Search& search) {
    for (std::size_t i = 0; i < search.waiting.size(); ++i) {
        const DramRequest& request = search.waiting[i].request;
        if (i != search.command.index && search.is_hit(request) &&
            search.device.takes_columns(request.bank, search.now))
            return true;
    }
    return false;
}

// An activate of `bank` that could go out now leaves the slot to the oldest request's that is due.
bool DramScheduler::steps_back(std::uint32_t bank,
                               const WaitingRequests& waiting,
                               const DramDevice& device,
                               MemoryCycle now) const {
    if (!is_oldest_due(waiting, device, now)) return false;
    if (waiting.front().passed >= limit_) return true;
    return waiting.count_of(waiting.front().request.bank) > waiting.count_of(bank) + backlog_;
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
            if (search.consider_activate(i, request.bank)) return;
        } else if ((search.hits & bank) == 0 || search.waiting[i].passed >= limit_) {
            const Ready ready = search.device.precharge_ready(request.bank);
            if (search.consider_precharge(i, ready.at)) return;
        } else {
            continue;
        }
        ++search.activates;
    }
}

// False, and nothing found, where a column could go out, the oldest request may not be passed, or
// an activate steps back for it.
// Else no request was passed too often, so that a bank works for its oldest one if nobody waits for
// the row that it has open.
inline bool DramScheduler::find_without_column(Search& search) const {
    const WaitingRequests& waiting = search.waiting;
    if (waiting.front().passed >= limit_) return false;
    BanksFound found;
    scan_banks({.banks = banks_,
                .times = search.device.bank_times(),
                .of_bank = waiting.of_banks(),
                .reads = waiting.hits() & waiting.of_kind(false),
                .writes = waiting.hits() & waiting.of_kind(true),
                .read_at = search.device.bus_ready_at(false),
                .write_at = search.device.bus_ready_at(true),
                .activate_at = search.device.any_activate_at(),
                .row_slot = search.row_slot,
                .now = search.now},
               found);
    if (found.column_is_due) return false;
    if (found.rows == 0) {
        search.command.again_at = found.again_at;
        search.command.column_at = found.column_at;
        return true;
    }
    const auto index = static_cast<std::size_t>(std::countr_zero(found.rows));
    const std::uint32_t bank = waiting[index].request.bank;
    const bool closed = search.device.open_row(bank) == DramDevice::NoRow;
    if (closed && steps_back(bank, waiting, search.device, search.now)) return false;
    search.command = {.kind = closed ? DramCommand::Kind::Activate : DramCommand::Kind::Precharge,
                      .index = index};
    return true;
}

// The oldest column of each bank and kind, from the oldest to the youngest.
inline void DramScheduler::find_column_by_bits(Search& search) const {
    const WaitingRequests& waiting = search.waiting;
    const bool may_pass = waiting.front().passed < limit_;
    for (WaitingRequests::Bits left = waiting.hits(); left != 0;) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const DramRequest& request = waiting[i].request;
        left &= ~(waiting.of_bank(request.bank) & waiting.of_kind(request.write));
        const MemoryCycle ready_at = search.device.column_ready_at(request.bank, request.write);
        if (search.consider_column(i, may_pass, ready_at)) return;
    }
}

bool DramScheduler::is_bus_wanted_by_bits(const Search& search) {
    const WaitingRequests& waiting = search.waiting;
    const std::size_t found = search.command.index;
    WaitingRequests::Bits left = waiting.hits() & ~(WaitingRequests::Bits{1} << found);
    if ((left & waiting.of_bank(waiting[found].request.bank)) != 0) return true;
    while (left != 0) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t bank = waiting[i].request.bank;
        if (search.device.takes_columns(bank, search.now)) return true;
        left &= ~waiting.of_bank(bank);
    }
    return false;
}

// The oldest request of each bank, from the oldest to the youngest.
void DramScheduler::find_row_by_bits(Search& search) const {
    const WaitingRequests& waiting = search.waiting;
    for (WaitingRequests::Bits left = waiting.all(); left != 0;) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t bank = waiting[i].request.bank;
        const WaitingRequests::Bits hits = waiting.hits() & waiting.of_bank(bank);
        left &= ~waiting.of_bank(bank);
        if ((hits >> i & 1) != 0) continue;
        if (search.device.open_row(bank) == DramDevice::NoRow) {
            if (search.consider_activate(i, bank)) return;
        } else if (hits == 0 || waiting[i].passed >= limit_) {
            const MemoryCycle ready_at = search.device.precharge_ready(bank).at;
            if (search.consider_precharge(i, ready_at)) return;
        } else {
            continue;
        }
        ++search.activates;
    }
}

// Where the oldest request is what data wait for: what it waits for, or waited for until now. Where
// nothing goes out though it could, younger ones still use its bank's row.
LostTo DramScheduler::why(const DramCommand& command,
                          const WaitingRequests& waiting,
                          const DramDevice& device,
                          MemoryCycle now) {
    if (waiting.empty()) return LostTo::NoRequest;
    const DramRequest& oldest = waiting.front().request;
    const std::uint64_t open_row = device.open_row(oldest.bank);
    const Ready ready = open_row == oldest.row          ? device.column_ready(oldest)
                        : open_row == DramDevice::NoRow ? device.activate_ready(oldest.bank)
                                                        : device.precharge_ready(oldest.bank);
    const bool goes_elsewhere = command.kind != DramCommand::Kind::None &&
                                waiting[command.index].request.bank != oldest.bank;
    const bool no_slot = device.free_slot(now) > now;
    LostTo cause = ready.at < now ? LostTo::Row : ready.cause;
    if (command.column_yields || ((goes_elsewhere || no_slot) && ready.at <= now))
        cause = LostTo::Commands;
    return command.order_forbids && cause != LostTo::Turnaround ? LostTo::Order : cause;
}

// A request for the open row of a bank that was to be closed for an older one keeps it open.
std::optional<MemoryCycle> DramScheduler::soonest_of(const DramRequest& request,
                                                     const WaitingRequests& waiting,
                                                     const DramDevice& device,
                                                     MemoryCycle now) const {
    if (!by_banks_ || waiting.empty() || waiting.front().passed >= limit_) return std::nullopt;
    if (is_oldest_due(waiting, device, now)) return std::nullopt; // One that stepped back may go.
    const WaitingRequests::Bits of_bank = waiting.of_bank(request.bank);
    if (device.open_row(request.bank) != request.row)
        return of_bank != 0 ? NoCycle
                            : std::max(device.row_ready_at(request.bank), device.free_slot(now));
    if (of_bank != 0 && (of_bank & waiting.hits()) == 0) return std::nullopt;
    return device.column_ready_at(request.bank, request.write);
}

// Behind the search for a column. Where one could go out and a row, too, the row goes if the bus
// stood still before the column, which is then not what limits; else the column. Now and then the
// other of the two does, but never before a column that follows while others want the bus, too.
template <class FindRow, class IsBusWanted>
void DramScheduler::choose_row(Search& search,
                               const FindRow& find_row,
                               const IsBusWanted& is_bus_wanted) const {
    if (!search.has_column()) return find_row();
    const std::size_t column = search.command.index;
    const bool follows = !search.device.bus_stood(search.write_of(column), search.now);
    if (follows && is_bus_wanted()) return;
    find_row();
    if (search.has_column()) return search.yield_to_held_activate();
    const bool slips = meetings_ % MeetingsToSlip == MeetingsToSlip - 1;
    if (follows == slips)
        search.column_yields = true;
    else
        search.command = {.kind = DramCommand::Kind::Column, .index = column};
    search.command.meets = true;
}

void DramScheduler::choose_plainly(Search& search) const {
    find_column(search);
    choose_row(
        search, [&] { find_row(search); }, [&] { return is_bus_wanted(search); });
}

void DramScheduler::choose_by_bits(Search& search) const {
    find_column_by_bits(search);
    choose_row(
        search, [&] { find_row_by_bits(search); }, [&] { return is_bus_wanted_by_bits(search); });
}

// No column can go out before command.column_at: the oldest request of a bank that could be made
// ready for it. A bank works for its oldest one, where nobody waits for the row that it has open.
inline void DramScheduler::choose_row_by_banks(const WaitingRequests& waiting,
                                               const DramDevice& device,
                                               MemoryCycle now,
                                               DramCommand& command) const {
    const MemoryCycle slot = device.free_slot(now);
    WaitingRequests::Bits ready = 0;
    for (std::uint64_t left = waiting.banks_without_hits(); left != 0; left &= left - 1) {
        const auto bank = static_cast<std::uint32_t>(std::countr_zero(left));
        const MemoryCycle at = std::max(device.row_ready_at(bank), slot);
        command.again_at = std::min(command.again_at, at);
        if (at <= now) ready |= waiting.of_bank(bank);
    }
    if (ready == 0) return;
    const auto index = static_cast<std::size_t>(std::countr_zero(ready));
    const std::uint32_t bank = waiting[index].request.bank;
    const bool closed = device.open_row(bank) == DramDevice::NoRow;
    if (closed && steps_back(bank, waiting, device, now)) {
        command = {.again_at = NoCycle};
        return choose_first_by_bits(waiting, device, now, command);
    }
    command = {.kind = closed ? DramCommand::Kind::Activate : DramCommand::Kind::Precharge,
               .index = index};
}

// All columns of a kind can go out at one time.
inline void DramScheduler::choose_by_bus(const WaitingRequests& waiting,
                                         const DramDevice& device,
                                         MemoryCycle now,
                                         DramCommand& command) const {
    const WaitingRequests::Bits reads = waiting.hits() & waiting.of_kind(false);
    const WaitingRequests::Bits writes = waiting.hits() & waiting.of_kind(true);
    const MemoryCycle read_at = reads != 0 ? device.bus_ready_at(false) : NoCycle;
    const MemoryCycle write_at = writes != 0 ? device.bus_ready_at(true) : NoCycle;
    const MemoryCycle at = std::min(read_at, write_at), when = std::max(at, now);
    const bool has_rows = waiting.banks_without_hits() != 0;
    if (at <= now && has_rows) return choose_first_by_bits(waiting, device, now, command);
    const WaitingRequests::Bits due =
        (read_at <= when ? reads : 0) | (write_at <= when ? writes : 0);
    command.index = static_cast<std::size_t>(std::countr_zero(due));
    if (at <= now) {
        command.kind = DramCommand::Kind::Column;
        return;
    }
    command.again_at = command.column_at = at;
    command.foresees_column = true;
    if (has_rows) choose_row_by_banks(waiting, device, now, command);
}

[[gnu::noinline]] void DramScheduler::choose_first_by_bits(const WaitingRequests& waiting,
                                                           const DramDevice& device,
                                                           MemoryCycle now,
                                                           DramCommand& command) const {
    Search search{*this, waiting, device, now, command};
    choose_by_bits(search);
    search.note_why();
}

void DramScheduler::choose(const WaitingRequests& waiting,
                           const DramDevice& device,
                           MemoryCycle now,
                           DramCommand& command) const {
    command = {.again_at = NoCycle};
    if (waiting.empty()) return;
    if (is_for_the_bus(waiting, device, now)) return choose_by_bus(waiting, device, now, command);
    choose_otherwise(waiting, device, now, command);
}

[[gnu::noinline]] void DramScheduler::choose_otherwise(const WaitingRequests& waiting,
                                                       const DramDevice& device,
                                                       MemoryCycle now,
                                                       DramCommand& command) const {
    Search search{*this, waiting, device, now, command};
    if (!by_bits_)
        choose_plainly(search);
    else if (!by_banks_ || !find_without_column(search))
        choose_by_bits(search);
    search.note_why();
}

void DramScheduler::choose_with_column(const WaitingRequests& waiting,
                                       const DramDevice& device,
                                       MemoryCycle now,
                                       DramCommand& command) const {
    if (command.foresees_column && command.column_at == now && waiting.banks_without_hits() == 0) {
        command.kind = DramCommand::Kind::Column;
        return;
    }
    command = {.again_at = NoCycle};
    if (is_for_the_bus(waiting, device, now)) return choose_by_bus(waiting, device, now, command);
    choose_first_by_bits(waiting, device, now, command);
}

} // namespace ffgpu::timing
