#include "model/timing/command_ledger.h"

#include "model/base/check.h"

#include <utility>

namespace ffgpu::timing {

std::size_t CommandLedger::open(CommandKind kind, std::uint32_t number, std::uint64_t parts) {
    check(parts > 0, "a command without an end");
    entries_.push_back({{.kind = kind, .number = number}, parts});
    return entries_.size() - 1;
}

void CommandLedger::begin_cycle(std::uint64_t now) {
    if (now == cycle_) return;
    cycle_ = now;
    oldest_before_ = oldest_;
    charged_ = None;
}

// Units are called in any order: a command before the one that was charged in this cycle takes its
// cycles over.
void CommandLedger::charge(std::size_t entry, std::uint64_t now) {
    if (charged_ == None) {
        charge_ = now - charged_until_;
        charged_until_ = now;
    } else if (entry < charged_) {
        entries_[charged_].listed.cycles -= charge_;
    } else {
        return;
    }
    entries_[entry].listed.cycles += charge_;
    charged_ = entry;
}

void CommandLedger::count(Entry& entry) {
    check(entry.parts_left > 0, "a command ended twice");
    --entry.parts_left;
    while (oldest_ < entries_.size() && entries_[oldest_].parts_left == 0)
        ++oldest_;
}

void CommandLedger::retire(std::size_t entry, std::uint64_t now) {
    begin_cycle(now);
    charge(entry, now);
    count(entries_[entry]);
}

void CommandLedger::end_part(std::size_t entry, std::uint64_t now) {
    begin_cycle(now);
    if (entry == oldest_before_) charge(entry, now);
    count(entries_[entry]);
}

void CommandLedger::explain_charge(std::uint64_t now) {
    if (!charges_at(now)) return;
    WaitedCycles& waited = entries_[charged_].listed.waited;
    for (std::size_t i = 0; i < Resources; ++i)
        waited[i] += std::exchange(waited_[i], 0);
}

std::vector<CommandCycles> CommandLedger::end_frame(std::uint64_t now) {
    check(oldest_ == entries_.size(), "a frame ends with its commands");
    Entry& end = entries_.emplace_back(Entry{{.kind = CommandKind::FrameEnd}, 0});
    end.listed.cycles = now - charged_until_;
    end.listed.waited = std::exchange(waited_, {});
    charged_until_ = now;
    std::vector<CommandCycles> listed;
    for (const Entry& entry : entries_)
        listed.push_back(entry.listed);
    entries_.clear();
    oldest_ = oldest_before_ = 0;
    cycle_ = now;
    charged_ = None;
    return listed;
}

} // namespace ffgpu::timing
