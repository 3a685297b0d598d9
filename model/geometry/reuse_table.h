// ReuseTable: where in the vertex pool a vertex already lies, so that an index that comes again
// is not shaded again. Direct-mapped by the low bits of the vertex number; what is pushed out is
// shaded once more, to the same result.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu {

class ReuseTable {
public:
    // Forgets everything: the pool is empty again.
    void clear() {
        if (++epoch_ == 0) { // Entries of 2^32 clears ago would look fresh.
            entries_.fill({});
            epoch_ = 1;
        }
    }

    // The slot of vertex `number`; if it has none, it is appended to `numbers` and gets the slot
    // that is its place there.
    std::uint32_t slot_of(std::uint32_t number, std::vector<std::uint32_t>& numbers) {
        Entry& entry = entries_[number % Entries];
        if (entry.epoch != epoch_ || entry.number != number) {
            entry = {number, static_cast<std::uint32_t>(numbers.size()), epoch_};
            numbers.push_back(number);
        }
        return entry.slot;
    }

private:
    static constexpr std::uint32_t Entries = 4096;

    struct Entry {
        std::uint32_t number = 0, slot = 0, epoch = 0;
    };
    std::array<Entry, Entries> entries_{};
    std::uint32_t epoch_ = 0;
};

} // namespace ffgpu
