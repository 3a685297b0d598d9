// Which units are due when, against a list of all that was said.

#include "model/timing/calendar.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

TEST_CASE("a unit is due in every cycle that was named within the pages, else in its soonest") {
    std::mt19937 random(1);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    for (int run = 0; run < 20; ++run) {
        Calendar calendar;
        std::set<std::pair<Cycle, std::size_t>> due;
        std::vector<Cycle> far(Calendar::MostUnits, Never);
        Cycle now = 0;
        for (int step = 0; step < 2000; ++step) {
            for (std::uint64_t i = below(4); i > 0; --i) {
                const std::size_t unit = below(Calendar::MostUnits);
                const Cycle ahead = below(3) == 0 ? 1 + below(300) : 1 + below(66);
                calendar.add(unit, now + ahead, now);
                if (ahead < Calendar::Pages)
                    due.emplace(now + ahead, unit);
                else
                    far[unit] = std::min(far[unit], now + ahead);
            }
            calendar.add(below(Calendar::MostUnits), Never, now);

            Cycle next = due.empty() ? Never : due.begin()->first;
            for (const Cycle at : far)
                next = std::min(next, at);
            REQUIRE(calendar.next(now) == next);
            if (next == Never) continue;
            now = below(2) == 0 ? next : std::min(next, now + 1); // A cycle may have no unit.
            std::uint64_t expected = 0;
            for (; !due.empty() && due.begin()->first == now; due.erase(due.begin()))
                expected |= std::uint64_t{1} << due.begin()->second;
            for (std::size_t unit = 0; unit < far.size(); ++unit) {
                if (far[unit] != now) continue;
                expected |= std::uint64_t{1} << unit;
                far[unit] = Never;
            }
            REQUIRE(calendar.take(now) == expected);
        }
    }
}

} // namespace
} // namespace ffgpu::timing
