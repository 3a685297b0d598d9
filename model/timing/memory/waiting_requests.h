// WaitingRequests: the queue of a DRAM channel, in the order of arrival, and what the scheduler
// asks of it in every cycle, kept up to date with each change: as bits, bit i for the i-th request.
// Only the first 64 requests have bits; in longer queues the scheduler looks at the requests.

#pragma once

#include "model/timing/memory/bank_scan.h"
#include "model/timing/memory/dram_request.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

struct WaitingRequest {
    DramRequest request;
    RowResult result = RowResult::Hit; // so far: what had to be done for it
    std::uint32_t passed = 0;          // younger requests that were served before
};

class WaitingRequests {
public:
    using Bits = std::uint64_t;
    static constexpr std::size_t MostWithBits = 64;

    explicit WaitingRequests(std::uint32_t banks)
        : banks_(banks)
        , of_bank_((banks + BankTimes::Most - 1) / BankTimes::Most * BankTimes::Most, 0) {}

    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    WaitingRequest& operator[](std::size_t i) { return places_[first_ + i]; }
    const WaitingRequest& operator[](std::size_t i) const { return places_[first_ + i]; }
    const WaitingRequest& front() const { return places_[first_]; }
    const WaitingRequest* begin() const { return places_.data() + first_; }
    const WaitingRequest* end() const { return begin() + count_; }

    // `open_row` of its bank.
    void push(const DramRequest& request, std::uint64_t open_row) {
        if (count_ < MostWithBits) {
            const Bits it = Bits{1} << count_;
            of_bank_[request.bank] |= it;
            of_kind_[request.write] |= it;
            if (request.row == open_row) hits_ |= it;
            note_hits(request.bank);
        }
        if (first_ + count_ == end_) make_room();
        WaitingRequest& place = places_[first_ + count_++];
        place.request = request;
        place.result = RowResult::Hit;
        place.passed = 0;
    }

    // Takes the request out. Those before it have been passed, and move up; mostly there is none.
    void remove(std::size_t index) {
        const std::uint32_t bank = (*this)[index].request.bank;
        for (std::size_t i = index; i > 0; --i) {
            (*this)[i] = (*this)[i - 1];
            ++(*this)[i].passed;
        }
        ++first_;
        --count_;
        if (index >= MostWithBits) return;
        remove_bits(index);
        note_hits(bank);
    }

    // The bank has another row open, or none.
    void set_open_row(std::uint32_t bank, std::uint64_t row) {
        hits_ &= ~of_bank_[bank];
        for (Bits left = of_bank_[bank]; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            if ((*this)[i].request.row == row) hits_ |= left & -left;
        }
        note_hits(bank);
    }

    // Looks at each.
    std::size_t count_of(std::uint32_t bank) const {
        return static_cast<std::size_t>(
            std::count_if(begin(), end(), [bank](const WaitingRequest& waiting) {
                return waiting.request.bank == bank;
            }));
    }

    // All bits are right where the queue never has more than MostWithBits requests.
    Bits all() const { return size() < MostWithBits ? (Bits{1} << size()) - 1 : ~Bits{0}; }
    Bits hits() const { return hits_; } // Their rows are open.
    Bits of_bank(std::uint32_t bank) const { return of_bank_[bank]; }
    // Of all, a word each; at least BankTimes::Most words.
    const Bits* of_banks() const { return of_bank_.data(); }
    Bits of_kind(bool write) const { return of_kind_[write]; }
    // Of banks a bit each: those that requests wait for, but none for the row that is open.
    Bits banks_without_hits() const { return without_hits_; }

private:
    static constexpr std::size_t AtATime = 4;
    static_assert(BankTimes::Most % AtATime == 0);

    void remove_bits(std::size_t index) {
        const Bits before = (Bits{1} << index) - 1;
        const auto close_up = [=](Bits& bits) { bits = (bits & before) | ((bits >> 1) & ~before); };
        // Some at a time, whose number is known: by vectors.
        for (std::size_t bank = 0; bank < banks_; bank += AtATime)
            for (std::size_t i = 0; i < AtATime; ++i)
                close_up(of_bank_[bank + i]);
        for (Bits& bits : of_kind_)
            close_up(bits);
        close_up(hits_);
    }

    void note_hits(std::uint32_t bank) {
        const Bits waiting = of_bank_[bank];
        const Bits has_none{waiting != 0 && (waiting & hits_) == 0};
        without_hits_ = (without_hits_ & ~(Bits{1} << bank)) | has_none << bank;
    }

    // Behind the last, where half of the places are free; else there are as many again.
    void make_room() {
        if (2 * count_ >= places_.size()) places_.resize(2 * places_.size() + 8);
        std::copy_n(places_.begin() + static_cast<std::ptrdiff_t>(first_), count_, places_.begin());
        first_ = 0;
        end_ = places_.size();
    }

    std::vector<WaitingRequest> places_;
    std::size_t end_ = 0;               // places_.size(), which is a division
    std::size_t first_ = 0, count_ = 0; // those in use
    std::size_t banks_;
    std::vector<Bits> of_bank_;     // those behind the last stay empty
    std::array<Bits, 2> of_kind_{}; // reads, writes
    Bits hits_ = 0, without_hits_ = 0;
};

} // namespace ffgpu::timing
