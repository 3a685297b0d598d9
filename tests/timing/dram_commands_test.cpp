// What goes out on a channel's command bus, by hand from the timings. dram_commands.py has the
// rules of the data sheets for whole frames.

#include "tests/timing/nobody_watches.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::timing {
namespace {

class Lines final : public DramCommandObserver {
public:
    std::vector<std::string> lines;

private:
    void issued(const IssuedCommand& command) override {
        std::string line =
            fmt::format("{} {} {}",
                        command.at,
                        DramOperationNames[static_cast<std::size_t>(command.operation)],
                        command.bank);
        if (command.bursts > 1) line += fmt::format(" x{}", command.bursts);
        lines.push_back(std::move(line));
    }
};

std::vector<std::string>
commands(const MemoryConfig& config, const std::vector<DramRequest>& requests, MemoryCycle end) {
    NobodyWatches silent;
    Lines lines;
    DramChannel channel(config, 0, silent);
    channel.set_command_observer(&lines);
    for (const DramRequest& request : requests)
        channel.push(request, 0);
    channel.settle(end);
    return lines.lines;
}

MemoryConfig without_refresh() {
    MemoryConfig config;
    config.refresh_interval_cycles = 0;
    config.refresh_cycles = 0;
    return config;
}

using List = std::vector<std::string>;

TEST_CASE("a row is opened, read from, and closed for another when tRAS and tRTP allow") {
    MemoryConfig config = without_refresh();
    config.row_to_column_cycles = 5;
    config.row_active_cycles = 17;
    config.precharge_cycles = 6;
    const DramRequest first{.bank = 2, .row = 1, .bytes = 16};
    const DramRequest other{.bank = 2, .row = 9, .bytes = 16};
    CHECK(commands(config, {first, other}, 100) ==
          List{"0 ACT 2", "5 RD 2", "17 PRE 2", "23 ACT 2", "28 RD 2"});
}

// Four bursts of two cycles go out at 4, 6, 8 and 10. tRRD would let the third row be opened in
// cycle 10.
TEST_CASE("rows are opened between a request's columns, not in their cycles") {
    MemoryConfig config = without_refresh();
    config.row_to_column_cycles = 4;
    config.activate_to_activate_cycles = 5;
    const auto read = [](std::uint32_t bank) { return DramRequest{.bank = bank, .bytes = 64}; };
    CHECK(commands(config, {read(0), read(1), read(2)}, 100) ==
          List{"0 ACT 0", "4 RD 0 x4", "5 ACT 1", "11 ACT 2", "12 RD 1 x4", "20 RD 2 x4"});
}

// In cycle 4 the first column and the second activate meet. Nothing was on the bus before.
TEST_CASE("a row is opened before a column that the bus stood still for") {
    MemoryConfig config = without_refresh();
    config.row_to_column_cycles = 4;
    config.activate_to_activate_cycles = 4;
    const auto read = [](std::uint32_t bank) { return DramRequest{.bank = bank, .bytes = 16}; };
    CHECK(commands(config, {read(0), read(1)}, 100) ==
          List{"0 ACT 0", "4 ACT 1", "5 RD 0", "8 RD 1"});
}

// The data of the column in cycle 6 follow those of the one in cycle 4; cycle 6 is the first in
// which tRRD lets the second row be opened.
TEST_CASE("a row is opened behind a column that leaves no gap on the bus") {
    MemoryConfig config = without_refresh();
    config.row_to_column_cycles = 4;
    config.activate_to_activate_cycles = 6;
    const auto read = [](std::uint32_t bank) { return DramRequest{.bank = bank, .bytes = 16}; };
    CHECK(commands(config, {read(0), read(0), read(1)}, 100) ==
          List{"0 ACT 0", "4 RD 0", "6 RD 0", "7 ACT 1", "11 RD 1"});
}

// Bursts of one cycle leave no room before the last of them.
TEST_CASE("columns in each cycle hold the row commands up") {
    MemoryConfig config = without_refresh();
    config.burst_cycles = config.column_to_column_cycles = 1;
    config.row_to_column_cycles = 3;
    config.activate_to_activate_cycles = 4;
    const auto read = [](std::uint32_t bank) { return DramRequest{.bank = bank, .bytes = 64}; };
    CHECK(commands(config, {read(0), read(1)}, 100) ==
          List{"0 ACT 0", "3 RD 0 x8", "11 ACT 1", "14 RD 1 x8"});
}

// The refresh is due while the row that closes by itself still takes its data: WL 1, four bursts to
// cycle 4 + 6 + 1 + 2 = 13, tWR 3: closed in cycle 16, refreshed tRP = 4 later.
TEST_CASE("a refresh waits for a row that closes by itself, and closes no other before") {
    MemoryConfig config = without_refresh();
    config.page_policy = PagePolicy::Closed;
    config.row_to_column_cycles = 4;
    config.row_active_cycles = 8;
    config.activate_to_activate_cycles = 1;
    config.write_recovery_cycles = 3;
    config.refresh_interval_cycles = 6;
    config.refresh_cycles = 14;
    const DramRequest write{.bank = 0, .bytes = 64, .write = true};
    const DramRequest later{.bank = 1, .bytes = 16, .write = true};
    const List seen = commands(config, {write, later}, 30);
    REQUIRE(seen.size() >= 5);
    CHECK(List(seen.begin(), seen.begin() + 5) ==
          List{"0 ACT 0", "1 ACT 1", "4 WRA 0 x4", "16 PREA 0", "20 REF 0"});
}

} // namespace
} // namespace ffgpu::timing
