#include "model/timing/command_ledger.h"

#include "model/base/check.h"

namespace ffgpu::timing {

std::size_t CommandLedger::open(CommandKind kind, std::uint32_t number, std::uint64_t parts) {
    check(parts > 0, "a command without an end");
    entries_.push_back({{kind, number, 0}, parts});
    return entries_.size() - 1;
}

void CommandLedger::charge(Entry& entry, std::uint64_t now) {
    entry.listed.cycles += now - charged_until_;
    charged_until_ = now;
}

void CommandLedger::count(Entry& entry) {
    check(entry.parts_left > 0, "a command ended twice");
    --entry.parts_left;
    while (oldest_ < entries_.size() && entries_[oldest_].parts_left == 0)
        ++oldest_;
}

void CommandLedger::retire(std::size_t entry, std::uint64_t now) {
    charge(entries_[entry], now);
    count(entries_[entry]);
}

void CommandLedger::end_part(std::size_t entry, std::uint64_t now) {
    if (entry == oldest_) charge(entries_[entry], now);
    count(entries_[entry]);
}

std::vector<CommandCycles> CommandLedger::end_frame(std::uint64_t now) {
    check(oldest_ == entries_.size(), "a frame ends with its commands");
    Entry& end = entries_.emplace_back(Entry{{CommandKind::FrameEnd, 0, 0}, 0});
    charge(end, now);
    std::vector<CommandCycles> listed;
    for (const Entry& entry : entries_)
        listed.push_back(entry.listed);
    entries_.clear();
    oldest_ = 0;
    return listed;
}

} // namespace ffgpu::timing
