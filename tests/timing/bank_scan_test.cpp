// One look at all banks of a channel: by vectors and plainly.

#include "model/timing/memory/bank_scan.h"

#include <array>
#include <cstdint>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

TEST_CASE("A look at all banks by vectors finds what the plain one finds", "[timing][dram]") {
    std::mt19937_64 random(20031);
    const auto below = [&](std::uint64_t end) { return random() % end; };
    for (int round = 0; round < 200000; ++round) {
        const MemoryCycle now = 100 + below(20);
        const auto near_now = [&] { return below(3) == 0 ? now + below(2) : 90 + below(40); };
        BankTimes times;
        std::array<std::uint64_t, BankTimes::Most> of_bank{};
        const std::size_t banks = std::size_t{1} << below(4);
        std::uint64_t waiting = below(4) == 0 ? random() : random() & random() & random();
        for (std::size_t bank = 0; bank < banks; ++bank) {
            times.column_at[bank] = near_now();
            times.row_at[bank] = near_now();
            times.closed[bank] = below(2) - 1;
        }
        for (; waiting != 0; waiting &= waiting - 1)
            of_bank[below(banks)] |= waiting & -waiting;
        const std::uint64_t reads = random(), hits = below(3) == 0 ? 0 : random() & random();
        const BankScan scan{.banks = banks,
                            .times = times,
                            .of_bank = of_bank.data(),
                            .reads = hits & reads,
                            .writes = hits & ~reads,
                            .read_at = near_now(),
                            .write_at = near_now(),
                            .activate_at = near_now(),
                            .row_slot = now + below(3),
                            .now = now};
        const BanksFound plainly = scan_banks_plainly(scan);
        BanksFound found;
        scan_banks(scan, found);
        REQUIRE(found.column_is_due == plainly.column_is_due);
        REQUIRE(found.column_at == plainly.column_at);
        REQUIRE(found.again_at == plainly.again_at);
        REQUIRE(found.rows == plainly.rows);
    }
}

} // namespace
} // namespace ffgpu::timing
