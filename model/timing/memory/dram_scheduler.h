// DramScheduler: which command goes out in a cycle. First-ready, first-come first-served (S. Rixner
// et al., Memory Access Scheduling, ISCA 2000): the oldest request whose column may go out; else
// the oldest whose bank can be made ready. A column before which the bus stood still lets that bank
// go first: the bus is not what limits then, and a bank that is late for a row is late for all its
// rows to come. It is not late where its activate waits for those of older requests anyway: then
// the column goes before its precharge. Two banks whose commands meet round after round would delay
// each other by as much and never part; so one in MeetingsToSlip of their meetings goes the other
// way. Banks also delay each other by the distance of activates: one of a younger request leaves
// the slot to the oldest's, which would come soon, where so many more requests wait for that bank
// that it is what limits, or where the oldest may not be passed anyway. Where rows go by the
// distance of activates, a request of several columns waits a cycle rather than that one behind the
// first takes the next activate's slot, if no other column wants the bus. A request that
// reorder_limit younger ones have passed is passed no more. In order is the same with a limit of
// zero: data in the order of the requests, rows opened ahead.
//
// Two forms of one rule: the plain one looks at each request, and is the specification; the other
// looks at the bits of WaitingRequests, at a request for each bank and kind, where the queue has
// them. Mostly tRCD of all rows is over: then the bus alone says when a column goes, and of the
// banks those matter alone that wait for another row, mostly none or one. Else mostly nothing can
// go out, or a row alone: where banks are few, one look at all of them tells so, in which nothing
// is to be foretold (bank_scan.h).

#pragma once

#include "model/timing/memory/dram_device.h"
#include "model/timing/memory/waiting_requests.h"

#include <optional>

namespace ffgpu::timing {

struct DramCommand {
    enum class Kind : std::uint8_t { None, Column, Activate, Precharge };
    Kind kind = Kind::None;
    std::size_t index = 0;           // of the waiting request
    MemoryCycle again_at = 0;        // None: nothing can go out before
    MemoryCycle column_at = NoCycle; // None: a column can go out then, where that is known
    bool foresees_column = false;    // None: that of `index`, if no bank waits for a row then
    bool meets = false;              // a column and a row: one goes, both could
    // Why no data flow: a column's could, but a bank's row went first; a younger request's could,
    // but for the order. Neither: for what the oldest request waits for.
    bool column_yields = false, order_forbids = false;

    bool waits_for_oldest() const { return !column_yields && !order_forbids; }
};

class DramScheduler {
public:
    // `plainly`: not by bits even where the queue has them.
    explicit DramScheduler(const MemoryConfig& config, bool plainly = false)
        : limit_(config.scheduler == SchedulerKind::InOrder ? 0 : config.reorder_limit)
        , by_bits_(!plainly && config.queue <= WaitingRequests::MostWithBits)
        , by_banks_(by_bits_ && config.banks <= FewBanks)
        , banks_(config.banks)
        , backlog_(config.queue / 4) {}

    // Writes it to `command`, whose numbers are read at once: a copy would wait for each of them
    // (model/base/one_store.h).
    void choose(const WaitingRequests& waiting,
                const DramDevice& device,
                MemoryCycle now,
                DramCommand& command) const;
    // The same where a look before, since which nothing went out, told that a column is due:
    // `command` is what it found, and what came since is younger.
    void choose_with_column(const WaitingRequests& waiting,
                            const DramDevice& device,
                            MemoryCycle now,
                            DramCommand& command) const;
    // Since `waiting` was looked at nothing could go out: `request`, which is not in it yet and
    // comes at `now`, may go out then, or ask for its row; NoCycle: others ask for that. None: all
    // have to be looked at again.
    std::optional<MemoryCycle> soonest_of(const DramRequest& request,
                                          const WaitingRequests& waiting,
                                          const DramDevice& device,
                                          MemoryCycle now) const;
    // Why no data flow where this command was chosen, which is no column, and has not gone out yet.
    static LostTo why(const DramCommand& command,
                      const WaitingRequests& waiting,
                      const DramDevice& device,
                      MemoryCycle now);
    // The command that was chosen goes out.
    void issued(const DramCommand& command) { meetings_ += command.meets; }

private:
    static constexpr std::uint32_t MeetingsToSlip = 32;
    static constexpr std::uint32_t FewBanks = BankTimes::Most;

    struct Search;
    // tRCD of all rows is over, and no request was passed too often.
    bool is_for_the_bus(const WaitingRequests& waiting,
                        const DramDevice& device,
                        MemoryCycle now) const {
        return by_bits_ && device.all_take_columns_at() <= now && waiting.front().passed < limit_;
    }
    void choose_by_bus(const WaitingRequests& waiting,
                       const DramDevice& device,
                       MemoryCycle now,
                       DramCommand& command) const;
    void choose_row_by_banks(const WaitingRequests& waiting,
                             const DramDevice& device,
                             MemoryCycle now,
                             DramCommand& command) const;
    void choose_first_by_bits(const WaitingRequests& waiting,
                              const DramDevice& device,
                              MemoryCycle now,
                              DramCommand& command) const;
    void choose_otherwise(const WaitingRequests& waiting,
                          const DramDevice& device,
                          MemoryCycle now,
                          DramCommand& command) const;
    // The oldest request's bank has no row open, and its activate could go out soon, but would have
    // to wait for its distance from one that goes out now.
    static bool
    is_oldest_due(const WaitingRequests& waiting, const DramDevice& device, MemoryCycle now) {
        const std::uint32_t bank = waiting.front().request.bank;
        if (device.open_row(bank) != DramDevice::NoRow) return false;
        const MemoryCycle at = device.activate_ready_at(bank);
        return at > now && device.is_too_near(now, at);
    }
    bool steps_back(std::uint32_t bank,
                    const WaitingRequests& waiting,
                    const DramDevice& device,
                    MemoryCycle now) const;
    void choose_plainly(Search& search) const;
    void find_column(Search& search) const;
    void find_row(Search& search) const;
    bool find_without_column(Search& search) const;
    void choose_by_bits(Search& search) const;
    void find_column_by_bits(Search& search) const;
    void find_row_by_bits(Search& search) const;
    static bool is_bus_wanted(const Search& search);
    static bool is_bus_wanted_by_bits(const Search& search);
    template <class FindRow, class IsBusWanted>
    void
    choose_row(Search& search, const FindRow& find_row, const IsBusWanted& is_bus_wanted) const;

    const std::uint32_t limit_;
    const bool by_bits_, by_banks_;
    const std::uint32_t banks_;
    const std::size_t backlog_; // requests more than for another bank, for a bank that limits
    std::uint32_t meetings_ = 0;
};

} // namespace ffgpu::timing
