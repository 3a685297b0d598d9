// Where an address lies: its channel, and in it bank and row. Interleaving goes over channels by
// interleave_bytes; the bytes of a channel fill a row of one bank, then a row of the next bank.
// Which bank is the next, bank_hash says (Z. Zhang, Z. Zhu and X. Zhang, A Permutation-based Page
// Interleaving Scheme, MICRO 2000).

#pragma once

#include "model/base/powers_of_two.h"
#include "model/timing/memory/config.h"

#include <algorithm>
#include <cstdint>

namespace ffgpu::timing {

inline std::uint32_t memory_channel(const MemoryConfig& config, std::uint64_t address) {
    return static_cast<std::uint32_t>(quotient(address, config.interleave_bytes)) &
           (config.channels - 1);
}

struct DramPlace {
    std::uint32_t channel = 0;
    std::uint32_t bank = 0;
    std::uint64_t row = 0;
};

inline std::uint32_t bank_of(const MemoryConfig& config, std::uint64_t row_of_bank) {
    if (config.bank_hash == work::IndexHash::Modulo)
        return static_cast<std::uint32_t>(row_of_bank) & (config.banks - 1);
    return static_cast<std::uint32_t>(work::SetIndex(config.banks, config.bank_hash)(row_of_bank));
}

// Of the channel's own bytes.
inline std::uint64_t in_channel(const MemoryConfig& config, std::uint64_t address) {
    const std::uint64_t block =
        quotient(quotient(address, config.interleave_bytes), config.channels);
    return block * config.interleave_bytes + remainder(address, config.interleave_bytes);
}

// In the row.
inline std::uint64_t row_offset(const MemoryConfig& config, std::uint64_t address) {
    return remainder(in_channel(config, address), config.row_bytes);
}

inline DramPlace place_of(const MemoryConfig& config, std::uint64_t address) {
    const std::uint64_t row_of_bank = quotient(in_channel(config, address), config.row_bytes);
    return {.channel = memory_channel(config, address),
            .bank = bank_of(config, row_of_bank),
            .row = quotient(row_of_bank, config.banks)};
}

// Whether [address, address + bytes) is one row of one channel.
inline bool
is_in_one_place(const MemoryConfig& config, std::uint64_t address, std::uint32_t bytes) {
    const std::uint64_t last = address + bytes - 1;
    const std::uint64_t one_place = std::min(config.interleave_bytes, config.row_bytes);
    if (quotient(address, one_place) == quotient(last, one_place)) return true;
    const DramPlace begin = place_of(config, address), end = place_of(config, last);
    return (config.channels == 1 || quotient(address, config.interleave_bytes) ==
                                        quotient(last, config.interleave_bytes)) &&
           begin.row == end.row && begin.bank == end.bank;
}

} // namespace ffgpu::timing
