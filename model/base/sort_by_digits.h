// sort_by_digits(): a stable sort by an unsigned number of each item, digit after digit from the
// lowest on (D. Knuth, The Art of Computer Programming 3, 5.2.5, radix list sort): no comparison
// that a processor would have to foretell. Bits above and below all in which items differ take no
// pass. By several numbers: the least significant one first.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu {

// `number(item)`: an unsigned integer. `spare`: memory that stays, for another such sort. There are
// fewer than 2^32 items.
template <class Item, class Number>
void sort_by_digits(std::vector<Item>& items, std::vector<Item>& spare, const Number& number) {
    constexpr unsigned MostBits = 11; // of a digit: a table that the first level of caches holds
    if (items.empty()) return;
    const auto first = number(items.front());
    auto differing = first;
    differing = 0;
    for (const Item& item : items)
        differing |= number(item) ^ first;
    if (differing == 0) return;
    spare.resize(items.size());
    const auto end = static_cast<unsigned>(std::bit_width(differing));
    auto shift = static_cast<unsigned>(std::countr_zero(differing));
    const unsigned passes = (end - shift + MostBits - 1) / MostBits;
    const unsigned bits = (end - shift + passes - 1) / passes;
    const std::size_t digits = std::size_t{1} << bits;
    std::array<std::uint32_t, std::size_t{1} << MostBits> places; // of the next item with a digit
    for (; shift < end; shift += bits) {
        const auto digit = [&](const Item& item) {
            return static_cast<std::size_t>(number(item) >> shift) & (digits - 1);
        };
        std::fill_n(places.begin(), digits, 0);
        for (const Item& item : items)
            ++places[digit(item)];
        std::uint32_t before = 0;
        for (std::size_t i = 0; i < digits; ++i)
            before += std::exchange(places[i], before);
        for (const Item& item : items)
            spare[places[digit(item)]++] = item;
        std::swap(items, spare);
    }
}

} // namespace ffgpu
