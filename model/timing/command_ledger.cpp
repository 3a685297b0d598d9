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
    note_charge();
    cycle_ = now;
    oldest_before_ = oldest_;
    charged_ = Nobody;
}

// Units are called in any order: a command before the one that was charged in this cycle takes its
// cycles over.
void CommandLedger::charge(std::size_t entry, std::uint64_t now) {
    if (charged_ == Nobody) {
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

// A charge in an earlier cycle is sure now, and has only what was moved until then.
void CommandLedger::moved(const MemoryRequest& request, std::uint64_t now) {
    begin_cycle(now);
    MovedBytes& bytes = moved_[static_cast<std::size_t>(request.client)];
    (request.write ? bytes.written : bytes.read) += request.bytes;
    any_moved_ = true;
}

void CommandLedger::give_moved(CommandCycles& to) {
    if (!std::exchange(any_moved_, false)) return;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
        const MovedBytes bytes = std::exchange(moved_[i], {});
        to.moved[i].read += bytes.read;
        to.moved[i].written += bytes.written;
    }
}

// It is sure now whom the cycles were charged to in the last cycle in which any were.
void CommandLedger::note_charge() {
    if (charged_ == Nobody) return;
    give_moved(entries_[charged_].listed);
    if (!charges_.empty() && charges_.back().entry == charged_)
        charges_.back().end = cycle_;
    else
        charges_.push_back({cycle_, charged_});
}

// Nobody looked where there are no runs.
void CommandLedger::explain(const FrameWaits& waits) {
    if (waits.runs.empty()) return;
    auto run = waits.runs.begin();
    std::uint64_t at = frame_begin_;
    for (const Charge& charge : charges_) {
        WaitedCycles& of = entries_[charge.entry].listed.waited;
        while (at < charge.end) {
            const std::uint64_t end = std::min(run->end, charge.end);
            of[static_cast<std::size_t>(run->resource)] += end - std::exchange(at, end);
            if (end == run->end) ++run;
        }
    }
    for (std::size_t i = 0; i < waits.saved_by.size(); ++i)
        entries_[i].listed.saved = waits.saved_by[i];
    entries_.back().listed.saved = waits.saved_at_end;
}

std::vector<CommandCycles> CommandLedger::end_frame(std::uint64_t now, const FrameWaits& waits) {
    check(oldest_ == entries_.size(), "a frame ends with its commands");
    Entry& end = entries_.emplace_back(Entry{{.kind = CommandKind::FrameEnd}, 0});
    end.listed.cycles = now - charged_until_;
    note_charge();
    give_moved(end.listed);
    charges_.push_back({now, entries_.size() - 1});
    explain(waits);
    charges_.clear();
    charged_until_ = frame_begin_ = now;
    std::vector<CommandCycles> listed;
    for (const Entry& entry : entries_)
        listed.push_back(entry.listed);
    entries_.clear();
    oldest_ = oldest_before_ = 0;
    cycle_ = now;
    charged_ = Nobody;
    return listed;
}

} // namespace ffgpu::timing
