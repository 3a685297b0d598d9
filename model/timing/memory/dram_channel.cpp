#include "model/timing/memory/dram_channel.h"

#include "model/base/check.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

DramChannel::DramChannel(const MemoryConfig& config,
                         std::uint32_t number,
                         DramObserver& observer,
                         bool plainly)
    : config_(config)
    , number_(number)
    , observer_(observer)
    , device_(config)
    , scheduler_(config, plainly)
    , policy_(config)
    , waiting_(config.banks)
    , leaves_open_(!plainly && config.page_policy != PagePolicy::Timeout)
    , refresh_due_(config.refresh_interval_cycles == 0 ? NoCycle : config.refresh_interval_cycles) {
}

void DramChannel::push(const DramRequest& request, MemoryCycle now) {
    check(has_room(), "a request for a full DRAM channel");
    planned_at_ = NoCycle;
    wait_also_for(request, now);
    waiting_.push(request, device_.open_row(request.bank));
}

// Why the command's slot passed without a column: of the slot alone, or, where none went out, also
// of those behind it.
[[gnu::always_inline]] inline void DramChannel::note_why(const DramCommand& command,
                                                         MemoryCycle now) {
    const bool is_none = command.kind == DramCommand::Kind::None;
    if (is_none && command.waits_for_oldest() && !waiting_.empty()) return note_oldest(now);
    if (!is_none && leaves_open_ && now < charged_slots_)
        open_from_ = NoCycle;
    else
        find_cause(command, now);
}

void DramChannel::find_cause(const DramCommand& command, MemoryCycle now) {
    note(now, DramScheduler::why(command, waiting_, device_, now));
}

// The slots from there on are lost to what the oldest request waits for. As long as that is the
// oldest, and no command goes out, it can be found out later; mostly nobody has to, since the bus
// carries data all the time.
inline void DramChannel::note_oldest(MemoryCycle from) {
    close_cause(from);
    open_from_ = from;
    if (!leaves_open_) close_cause(NoCycle);
}

// Mostly it is enough to look at what has come. Where a column yields to another bank's row, that
// is why nothing flows, whatever comes.
inline void DramChannel::wait_also_for(const DramRequest& request, MemoryCycle now) {
    const auto soonest =
        rests_ ? scheduler_.soonest_of(request, waiting_, device_, now) : std::nullopt;
    if (soonest && *soonest > now) {
        if (counts_ && planned_.waits_for_oldest()) note_oldest(now);
        next_work_ = std::min(next_work_, *soonest);
        next_column_ = std::min(next_column_, *soonest);
    } else {
        next_work_ = std::min(next_work_, now);
        next_column_ = now;
        rests_ = false;
    }
}

// One cycle's command, or how long there will be none.
void DramChannel::work(MemoryCycle now) {
    next_column_ = now;
    const bool column_is_due = std::exchange(rests_, false) && planned_.column_at <= now;
    if (now >= refresh_due_) return work_on_refresh(now);
    if (column_is_due)
        scheduler_.choose_with_column(waiting_, device_, now, planned_);
    else if (planned_at_ != now)
        scheduler_.choose(waiting_, device_, now, planned_);
    if (planned_.kind == DramCommand::Kind::None) return rest(planned_, now);
    issue(planned_, now);
    look_ahead(now + 1);
}

inline void DramChannel::rest(const DramCommand& none, MemoryCycle now) {
    if (counts_) note_why(none, now);
    next_work_ = std::min(none.again_at, refresh_due_);
    if (config_.page_policy == PagePolicy::Timeout) return rest_until_timeout(now);
    rests_ = true;
    // A row that is opened meanwhile takes columns later.
    if (none.column_at != NoCycle || none.foresees_column)
        next_column_ =
            std::min({none.column_at, none.again_at + config_.row_to_column_cycles, refresh_due_});
}

void DramChannel::rest_until_timeout(MemoryCycle now) {
    if (!close_idle_row(now)) next_work_ = std::min(next_work_, next_row_to_close(now));
}

// Behind a command mostly nothing can go out, and nobody has to come back to see that. What is
// pushed meanwhile has the cycle looked at again.
inline void DramChannel::look_ahead(MemoryCycle next) {
    next_work_ = next;
    if (next >= refresh_due_ || config_.page_policy == PagePolicy::Timeout) return;
    scheduler_.choose(waiting_, device_, next, planned_);
    planned_at_ = next;
    if (planned_.kind == DramCommand::Kind::None) rest(planned_, next);
}

// Closes all rows, then refreshes.
void DramChannel::work_on_refresh(MemoryCycle now) {
    note(now, waiting_.empty() ? LostTo::NoRequest : LostTo::Refresh);
    const bool must_close = device_.any_row_open();
    const MemoryCycle allowed =
        must_close ? device_.all_precharge_ready() : device_.refresh_ready();
    const MemoryCycle ready = device_.free_slot(std::max(allowed, now));
    if (ready > now) {
        next_work_ = ready;
        return;
    }
    if (must_close) {
        device_.precharge_all(now);
        tell_command(DramOperation::PREA, now);
        for (std::uint32_t bank = 0; bank < config_.banks; ++bank)
            waiting_.set_open_row(bank, DramDevice::NoRow);
    } else {
        device_.refresh(now);
        tell_command(DramOperation::REF, now);
        observer_.on_refresh();
        refresh_due_ += config_.refresh_interval_cycles;
    }
    next_work_ = now + 1;
}

inline void DramChannel::issue(const DramCommand& command, MemoryCycle now) {
    WaitingRequest& waiting = waiting_[command.index];
    const DramRequest& request = waiting.request;
    scheduler_.issued(command);
    switch (command.kind) {
    case DramCommand::Kind::Column:
        return serve(command.index, now);
    case DramCommand::Kind::Activate:
        if (counts_) note_why(command, now);
        device_.activate(request.bank, request.row, now);
        tell_command(DramOperation::ACT, now, request.bank, request.row);
        waiting_.set_open_row(request.bank, request.row);
        waiting.result = std::max(waiting.result, RowResult::Miss);
        return;
    case DramCommand::Kind::Precharge:
        if (counts_) note_why(command, now);
        precharge(request.bank, now);
        waiting.result = RowResult::Conflict;
        return;
    case DramCommand::Kind::None:
        return;
    }
}

void DramChannel::precharge(std::uint32_t bank, MemoryCycle now) {
    device_.precharge(bank, now);
    tell_command(DramOperation::PRE, now, bank);
    waiting_.set_open_row(bank, DramDevice::NoRow);
}

inline void DramChannel::serve(std::size_t index, MemoryCycle now) {
    ServedRequest& served = served_.append();
    served.request = waiting_[index].request;
    const DramRequest& request = served.request;
    if (counts_) close_causes_before(request, now);
    const RowResult result = waiting_[index].result;
    waiting_.remove(index);

    const bool turns = request.write != device_.last_was_write();
    const bool is_first = !device_.has_carried_data();
    const DataBurst data = served.data = device_.column(request, now);
    if (counts_) {
        if (turns && !is_first) observer_.on_turnaround();
        to_tell_ = std::min(now, charged_);
        if (!tells_when_asked_) tell();
        charge_until(data, request.bytes, turns ? LostTo::Turnaround : LostTo::NoRequest);
        causes_.restart(now, waiting_.empty() ? LostTo::NoRequest : LostTo::Column);
        observer_.on_access(number_, request, result);
    }

    policy_.learn(request.bank, request.row, result);
    const auto wanted = [&] { return is_wanted(request.bank); };
    const bool closes = policy_.closes_behind(request.bank, wanted);
    if (commands_) tell_columns(request, closes, now);
    if (closes) {
        device_.auto_precharge(request.bank);
        waiting_.set_open_row(request.bank, DramDevice::NoRow);
    }
}

void DramChannel::tell_columns(const DramRequest& request, bool closes, MemoryCycle now) const {
    const DramOperation read = closes ? DramOperation::RDA : DramOperation::RD;
    const DramOperation write = closes ? DramOperation::WRA : DramOperation::WR;
    commands_->issued({.at = now,
                       .channel = number_,
                       .bank = request.bank,
                       .operation = request.write ? write : read,
                       .row = request.row,
                       .bursts = config_.bursts(request.bytes),
                       .byte = request.offset});
}

void DramChannel::find_open_cause() {
    causes_.note(open_from_, DramScheduler::why({}, waiting_, device_, open_from_));
}

// A column's data: nobody asks for causes where they follow those before.
inline void DramChannel::close_causes_before(const DramRequest& request, MemoryCycle now) {
    if (now + device_.column_latency(request.write) > charged_)
        close_cause(now);
    else
        open_from_ = NoCycle;
}

// The bus up to the end of these data: first the gap before them, by the causes of the command
// slots in which their column did not go out, then the bytes asked for, then the burst's rest.
inline void DramChannel::charge_until(const DataBurst& data, std::uint32_t bytes, LostTo before) {
    const auto lose = [&](LostTo cause, MemoryCycle cycles) { charge({false, cause, cycles}); };
    if (data.begin > charged_) {
        const MemoryCycle latency = device_.column_latency(device_.last_was_write());
        // In slots that the request before held itself, a turn waits for itself but for tCCD's
        // part.
        const bool turns = before == LostTo::Turnaround;
        MemoryCycle spaced = turns ? device_.spacing_beyond_turn() : NoCycle;
        const auto lose_slots = [&](LostTo cause, MemoryCycle cycles) {
            if (cause != LostTo::Column) return lose(cause, cycles);
            const MemoryCycle by_spacing = std::min(cycles, spaced);
            spaced -= by_spacing;
            if (by_spacing > 0) lose(LostTo::Column, by_spacing);
            if (cycles > by_spacing) lose(LostTo::Turnaround, cycles - by_spacing);
        };
        causes_.charge(data.begin - latency, data.begin - charged_, before, lose_slots);
    }
    const DramDevice::DataOf& of = device_.data_of(bytes);
    charge({true, {}, of.asked});
    if (of.on_bus > of.asked) lose(LostTo::Burst, of.on_bus - of.asked);
    if (data.end - data.begin > of.on_bus) lose(LostTo::Column, data.end - data.begin - of.on_bus);
    check(charged_ == data.end, "each cycle of the bus is charged once");
    note_charged();
}

// The next data's column may come as much before them as either kind's may.
inline void DramChannel::note_charged() {
    const MemoryCycle latency = std::max(config_.column_cycles, config_.write_column_cycles);
    charged_slots_ = charged_ - std::min(charged_, latency);
}

void DramChannel::charge_other(const Charge& charge) {
    if (untold_.size() >= MostUntold) tell();
    if (last_.cycles > 0) untold_.push_back(last_);
    last_ = charge;
    charged_ += charge.cycles;
}

// A column's data may lie beyond a frame's end.
void DramChannel::tell(MemoryCycle end) {
    while (told_ < end && !untold_.empty()) {
        tell(untold_.front(), end);
        if (untold_.front().cycles == 0) untold_.pop_front();
    }
    if (told_ < end) tell(last_, end);
}

void DramChannel::tell(Charge& charge, MemoryCycle end) {
    const MemoryCycle cycles = std::min(charge.cycles, end - told_);
    if (cycles == 0) return;
    charge.data ? observer_.on_data(cycles) : observer_.on_lost(charge.cause, cycles);
    told_ += cycles;
    charge.cycles -= cycles;
}

void DramChannel::settle(MemoryCycle end) {
    advance(end);
    if (!counts_) return;
    const MemoryCycle latency = device_.column_latency(false);
    if (charged_ < end) {
        close_cause(end);
        causes_.charge(end > latency ? end - latency : 0,
                       end - charged_,
                       LostTo::NoRequest,
                       [&](LostTo cause, MemoryCycle cycles) {
                           charge({false, cause, cycles});
                       });
        note_charged();
    }
    to_tell_ = end;
    tell();
}

bool DramChannel::is_wanted(std::uint32_t bank) const {
    return std::ranges::any_of(waiting_, [&](const WaitingRequest& waiting) {
        return waiting.request.bank == bank && waiting.request.row == device_.open_row(bank);
    });
}

bool DramChannel::close_idle_row(MemoryCycle now) {
    if (device_.free_slot(now) > now) return false;
    for (std::uint32_t bank = 0; bank < config_.banks; ++bank) {
        if (device_.open_row(bank) == DramDevice::NoRow || is_wanted(bank)) continue;
        if (policy_.closes_at(device_.last_column(bank)) > now) continue;
        if (device_.precharge_ready(bank).at > now) continue;
        precharge(bank, now);
        next_work_ = now + 1;
        return true;
    }
    return false;
}

// From the next cycle on, where none closed in this one.
MemoryCycle DramChannel::next_row_to_close(MemoryCycle now) const {
    MemoryCycle next = NoCycle;
    for (std::uint32_t bank = 0; bank < config_.banks; ++bank) {
        if (device_.open_row(bank) == DramDevice::NoRow || is_wanted(bank)) continue;
        next = std::min(next,
                        std::max(policy_.closes_at(device_.last_column(bank)),
                                 device_.precharge_ready(bank).at));
    }
    return std::max(next, now + 1);
}

} // namespace ffgpu::timing
