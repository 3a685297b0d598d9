// DramChannel: one channel of the memory, without a clock of its own. It jumps from one cycle in
// which something can happen to the next: choose a command, do it, ask the row policy, tell the
// observer.

#pragma once

#include "model/base/ring.h"
#include "model/timing/memory/dram_commands.h"
#include "model/timing/memory/dram_device.h"
#include "model/timing/memory/dram_scheduler.h"
#include "model/timing/memory/row_policy.h"

namespace ffgpu::timing {

// Served: its data are on the bus in [data.begin, data.end).
struct ServedRequest {
    DramRequest request;
    DataBurst data;
};

class DramChannel {
public:
    // `plainly`: with the scheduler's plain form.
    DramChannel(const MemoryConfig& config,
                std::uint32_t number,
                DramObserver& observer,
                bool plainly = false);

    // The observer is told no more.
    void leave_out_figures() { counts_ = false; }
    // Null: nobody.
    void set_command_observer(DramCommandObserver* observer) { commands_ = observer; }

    bool has_room() const { return waiting_.size() < config_.queue; }
    // In the queue from cycle `now` on, which must not have passed yet.
    void push(const DramRequest& request, MemoryCycle now);
    // Works through all cycles before `end`.
    void advance(MemoryCycle end) {
        while (next_work_ < end)
            work(next_work_);
    }
    // In the order of their data; the owner takes them out.
    Ring<ServedRequest>& served() { return served_; }
    const Ring<ServedRequest>& served() const { return served_; }

    // Nothing happens before that cycle unless something is pushed.
    MemoryCycle next_work() const { return next_work_; }
    // Nor does a column go out before that one.
    MemoryCycle next_column() const { return std::max(next_work_, next_column_); }
    bool has_waiting() const { return !waiting_.empty(); }
    std::size_t waiting() const { return waiting_.size(); }
    // Charges the bus's cycles before `end` that nothing was charged with yet.
    void settle(MemoryCycle end);
    // With each column the observer is told of all cycles up to it; or, from now on, when its owner
    // calls tell(), if not sooner.
    void tell_when_asked() { tells_when_asked_ = true; }
    void tell() { tell(to_tell_); }

private:
    static constexpr std::size_t MostUntold = 16;

    void wait_also_for(const DramRequest& request, MemoryCycle now);
    void work(MemoryCycle now);
    void rest(const DramCommand& none, MemoryCycle now);
    void rest_until_timeout(MemoryCycle now);
    void look_ahead(MemoryCycle next);
    void work_on_refresh(MemoryCycle now);
    bool close_idle_row(MemoryCycle now);
    void issue(const DramCommand& command, MemoryCycle now);
    void precharge(std::uint32_t bank, MemoryCycle now);
    void serve(std::size_t index, MemoryCycle now);
    void tell_columns(const DramRequest& request, bool closes, MemoryCycle now) const;
    void tell_command(DramOperation operation,
                      MemoryCycle now,
                      std::uint32_t bank = 0,
                      std::uint64_t row = 0) const {
        if (commands_) commands_->issued({now, number_, bank, operation, row, 1, 0});
    }
    // What the bus's cycles carried or were lost to.
    struct Charge {
        bool data = false;
        LostTo cause = LostTo::NoRequest; // where no data
        MemoryCycle cycles = 0;

        bool is_like(const Charge& other) const {
            return data == other.data && cause == other.cause;
        }
    };

    void note(MemoryCycle from, LostTo cause) {
        if (!counts_) return;
        close_cause(from);
        causes_.note(from, cause);
    }
    void note_why(const DramCommand& command, MemoryCycle now);
    void find_cause(const DramCommand& command, MemoryCycle now);
    void note_oldest(MemoryCycle from);
    // Another cause holds from `end` on.
    void close_cause(MemoryCycle end) {
        if (open_from_ < end && end > charged_slots_) find_open_cause();
        open_from_ = NoCycle;
    }
    void find_open_cause();
    void close_causes_before(const DramRequest& request, MemoryCycle now);
    void charge_until(const DataBurst& data, std::uint32_t bytes, LostTo before);
    // What follows its like is one with it.
    void charge(const Charge& charge) {
        if (charge.cycles == 0) return;
        if (!charge.is_like(last_)) return charge_other(charge);
        charged_ += charge.cycles;
        last_.cycles += charge.cycles;
    }
    void charge_other(const Charge& charge);
    void note_charged();
    void tell(MemoryCycle end);
    void tell(Charge& charge, MemoryCycle end);
    bool is_wanted(std::uint32_t bank) const;
    MemoryCycle next_row_to_close(MemoryCycle now) const;

    const MemoryConfig& config_;
    const std::uint32_t number_;
    DramObserver& observer_;
    DramCommandObserver* commands_ = nullptr;
    bool counts_ = true, tells_when_asked_ = false;
    DramDevice device_;
    DramScheduler scheduler_;
    RowPolicy policy_;
    WaitingRequests waiting_;
    Ring<ServedRequest> served_;
    const bool leaves_open_; // why nothing goes out, as long as nobody has to know
    SlotCauses causes_;
    MemoryCycle open_from_ = NoCycle; // From there on slots have the cause that the oldest names.
    MemoryCycle charged_ = 0;         // data cycles up to here have their cause
    MemoryCycle charged_slots_ = 0;   // and those of slots up to here, if not more
    MemoryCycle told_ = 0;            // and up to here the observer knows
    MemoryCycle to_tell_ = 0;         // up to there it is to
    Ring<Charge> untold_;             // from told_ on
    Charge last_;                     // behind these, to charged_
    MemoryCycle next_work_ = 0;       // nothing happens before
    MemoryCycle next_column_ = 0;     // no column goes out before, if that is later
    DramCommand planned_;             // what goes out in cycle planned_at_, unless something comes
    MemoryCycle planned_at_ = NoCycle;
    bool rests_ = false; // Until next_work_ nothing of what is there can go out.
    MemoryCycle refresh_due_;
};

} // namespace ffgpu::timing
