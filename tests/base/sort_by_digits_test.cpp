// sort_by_digits() against the standard library's stable sort, which compares.

#include "model/base/sort_by_digits.h"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

struct Item {
    std::uint64_t major = 0;
    std::uint32_t minor = 0;
    std::uint32_t came = 0; // as which of all

    bool operator==(const Item&) const = default;
};

// Numbers with as many bits, at any place in the word; some are equal.
std::vector<Item> random_items(std::mt19937_64& random, std::size_t count) {
    const auto below = [&](unsigned limit) { return static_cast<unsigned>(random() % limit); };
    const unsigned bits = 1 + below(40), shift = below(24), minor_bits = below(33);
    const std::uint64_t all_have = random();
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
        items.push_back(
            {(all_have & ~(mask << shift)) | (random() & mask) << shift,
             minor_bits == 0 ? 7 : static_cast<std::uint32_t>(random()) >> (32 - minor_bits),
             i});
    }
    return items;
}

TEST_CASE("by two numbers, the least significant one first") {
    std::mt19937_64 random(20);
    std::vector<Item> spare;
    for (const std::size_t count : {0u, 1u, 2u, 3u, 17u, 255u, 256u, 1000u, 5000u, 70000u})
        for (unsigned repeat = 0; repeat < 8; ++repeat) {
            std::vector<Item> items = random_items(random, count), expected = items;
            std::stable_sort(expected.begin(), expected.end(), [](const Item& a, const Item& b) {
                return std::pair(a.major, a.minor) < std::pair(b.major, b.minor);
            });
            sort_by_digits(items, spare, [](const Item& item) { return item.minor; });
            sort_by_digits(items, spare, [](const Item& item) { return item.major; });
            CAPTURE(count, repeat);
            CHECK(items == expected);
        }
}

TEST_CASE("items of one number stay as they came") {
    std::vector<Item> items, spare;
    for (std::uint32_t i = 0; i < 3000; ++i)
        items.push_back({i % 3, 0, i});
    sort_by_digits(items, spare, [](const Item& item) { return item.major; });
    for (std::uint32_t i = 0; i < 3000; ++i)
        CHECK(items[i] == Item{i / 1000, 0, i % 1000 * 3 + i / 1000});
}

} // namespace
} // namespace ffgpu
