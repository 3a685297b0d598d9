// Where an address lies: its channel, and in it bank and row. Interleaving goes over channels by
// interleave_bytes; the bytes of a channel fill a row of one bank, then a row of the next bank.
// Which bank is the next, bank_hash says (Z. Zhang, Z. Zhu and X. Zhang, A Permutation-based Page
// Interleaving Scheme, MICRO 2000).

#pragma once

#include "model/timing/memory/config.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace ffgpu::timing {

struct DramPlace {
    std::uint32_t channel = 0;
    std::uint32_t bank = 0;
    std::uint64_t row = 0;
};

class AddressMapping {
public:
    explicit AddressMapping(const MemoryConfig& config)
        : interleave_(config.interleave_bytes)
        , channels_(config.channels)
        , row_(config.row_bytes)
        , banks_(config.banks)
        , one_place_(std::min(config.interleave_bytes, config.row_bytes))
        , bank_of_(config.banks, config.bank_hash) {}

    std::uint32_t channel(std::uint64_t address) const {
        return static_cast<std::uint32_t>(channels_.remainder(interleave_.quotient(address)));
    }
    // In the row.
    std::uint64_t row_offset(std::uint64_t address) const {
        return row_.remainder(in_channel(address));
    }
    DramPlace place(std::uint64_t address) const {
        const std::uint64_t row_of_bank = row_.quotient(in_channel(address));
        return {.channel = channel(address),
                .bank = static_cast<std::uint32_t>(bank_of_(row_of_bank)),
                .row = banks_.quotient(row_of_bank)};
    }
    // Whether [address, address + bytes) is one row of one channel.
    bool is_in_one_place(std::uint64_t address, std::uint32_t bytes) const {
        const std::uint64_t last = address + bytes - 1;
        if (one_place_.quotient(address) == one_place_.quotient(last)) return true;
        const DramPlace begin = place(address), end = place(last);
        return (channels_.is_one() ||
                interleave_.quotient(address) == interleave_.quotient(last)) &&
               begin.row == end.row && begin.bank == end.bank;
    }

private:
    // A power of two whose shift is worked out once.
    class Power {
    public:
        explicit Power(std::uint32_t value)
            : shift_(std::countr_zero(value))
            , mask_(value - 1) {}
        std::uint64_t quotient(std::uint64_t value) const { return value >> shift_; }
        std::uint64_t remainder(std::uint64_t value) const { return value & mask_; }
        std::uint64_t product(std::uint64_t value) const { return value << shift_; }
        bool is_one() const { return mask_ == 0; }

    private:
        int shift_;
        std::uint64_t mask_;
    };

    // Of the channel's own bytes.
    std::uint64_t in_channel(std::uint64_t address) const {
        const std::uint64_t block = channels_.quotient(interleave_.quotient(address));
        return interleave_.product(block) + interleave_.remainder(address);
    }

    Power interleave_, channels_, row_, banks_, one_place_;
    work::SetIndex bank_of_;
};

// For who asks now and then.

inline std::uint32_t memory_channel(const MemoryConfig& config, std::uint64_t address) {
    return AddressMapping(config).channel(address);
}

inline std::uint64_t row_offset(const MemoryConfig& config, std::uint64_t address) {
    return AddressMapping(config).row_offset(address);
}

inline DramPlace place_of(const MemoryConfig& config, std::uint64_t address) {
    return AddressMapping(config).place(address);
}

} // namespace ffgpu::timing
