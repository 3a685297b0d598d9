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
#include <span>
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
        , of_bank_(std::max(std::size_t{banks}, BankTimes::Most), 0) {}

    bool empty() const { return requests_.empty(); }
    std::size_t size() const { return requests_.size(); }
    WaitingRequest& operator[](std::size_t i) { return requests_[i]; }
    const WaitingRequest& operator[](std::size_t i) const { return requests_[i]; }
    const WaitingRequest& front() const { return requests_.front(); }
    auto begin() const { return requests_.begin(); }
    auto end() const { return requests_.end(); }

    // `open_row` of its bank.
    void push(const DramRequest& request, std::uint64_t open_row) {
        if (const std::size_t i = requests_.size(); i < MostWithBits) {
            of_bank_[request.bank] |= Bits{1} << i;
            of_kind_[request.write] |= Bits{1} << i;
            if (request.row == open_row) hits_ |= Bits{1} << i;
        }
        requests_.push_back({.request = request});
    }

    // Takes the request out; those before it have been passed.
    void remove(std::size_t index) {
        for (std::size_t i = 0; i < index; ++i)
            ++requests_[i].passed;
        requests_.erase(requests_.begin() + static_cast<std::ptrdiff_t>(index));
        if (index >= MostWithBits) return;
        const Bits before = (Bits{1} << index) - 1;
        const auto close_gap = [&](Bits& bits) {
            bits = (bits & before) | ((bits >> 1) & ~before);
        };
        for (Bits& bits : std::span(of_bank_).first(banks_))
            close_gap(bits);
        for (Bits& bits : of_kind_)
            close_gap(bits);
        close_gap(hits_);
    }

    // The bank has another row open, or none.
    void set_open_row(std::uint32_t bank, std::uint64_t row) {
        hits_ &= ~of_bank_[bank];
        for (Bits left = of_bank_[bank]; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            if (requests_[i].request.row == row) hits_ |= left & -left;
        }
    }

    // All bits are right where the queue never has more than MostWithBits requests.
    Bits all() const { return size() < MostWithBits ? (Bits{1} << size()) - 1 : ~Bits{0}; }
    Bits hits() const { return hits_; } // Their rows are open.
    Bits of_bank(std::uint32_t bank) const { return of_bank_[bank]; }
    // Of all, a word each; at least BankTimes::Most words.
    const Bits* of_banks() const { return of_bank_.data(); }
    Bits of_kind(bool write) const { return of_kind_[write]; }

private:
    std::vector<WaitingRequest> requests_;
    std::size_t banks_;
    std::vector<Bits> of_bank_;     // those behind the last stay empty
    std::array<Bits, 2> of_kind_{}; // reads, writes
    Bits hits_ = 0;
};

} // namespace ffgpu::timing
