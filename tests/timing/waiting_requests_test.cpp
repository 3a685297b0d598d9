// What the queue of a DRAM channel keeps up to date, beside what a walk over its requests says.

#include "model/timing/memory/waiting_requests.h"

#include <array>
#include <random>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using Bits = WaitingRequests::Bits;

struct Kept {
    Bits hits = 0, without_hits = 0;
    std::array<Bits, 2> of_kind{};
    std::vector<Bits> of_bank;

    bool operator==(const Kept&) const = default;
};

Kept kept(const WaitingRequests& waiting, std::uint32_t banks) {
    Kept kept{waiting.hits(),
              waiting.banks_without_hits(),
              {waiting.of_kind(false), waiting.of_kind(true)},
              {}};
    for (std::uint32_t bank = 0; bank < banks; ++bank)
        kept.of_bank.push_back(waiting.of_bank(bank));
    return kept;
}

Kept walked(const WaitingRequests& waiting, const std::vector<std::uint64_t>& open_rows) {
    Kept walked{.of_bank = std::vector<Bits>(open_rows.size())};
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        const DramRequest& request = waiting[i].request;
        const Bits it = Bits{1} << i;
        walked.of_bank[request.bank] |= it;
        walked.of_kind[request.write] |= it;
        if (open_rows[request.bank] == request.row) walked.hits |= it;
    }
    for (std::size_t bank = 0; bank < open_rows.size(); ++bank) {
        const Bits of_bank = walked.of_bank[bank];
        if (of_bank != 0 && (of_bank & walked.hits) == 0) walked.without_hits |= Bits{1} << bank;
    }
    return walked;
}

TEST_CASE("the bits of waiting requests are what a walk over them finds", "[timing][dram]") {
    std::mt19937 random(41);
    const auto below = [&](std::size_t end) { return static_cast<std::uint32_t>(random() % end); };
    for (const std::uint32_t banks : {1u, 2u, 4u, 8u, 16u, 64u}) {
        WaitingRequests waiting(banks);
        std::vector<std::uint64_t> open_rows(banks, 3);
        for (std::uint32_t step = 0; step < 20000; ++step) {
            const std::uint32_t bank = below(banks), what = below(8);
            if (what < 4 && waiting.size() < WaitingRequests::MostWithBits) {
                waiting.push({.bank = bank, .row = below(4), .write = below(2) == 0},
                             open_rows[bank]);
            } else if (what < 7 && !waiting.empty()) {
                waiting.remove(below(waiting.size()));
            } else {
                open_rows[bank] = below(5); // of four that anybody waits for
                waiting.set_open_row(bank, open_rows[bank]);
            }
            REQUIRE(kept(waiting, banks) == walked(waiting, open_rows));
        }
    }
}

TEST_CASE("a request that is passed keeps its place before the younger ones", "[timing][dram]") {
    WaitingRequests waiting(4);
    for (std::uint32_t client = 0; client < 5; ++client)
        waiting.push({.bank = client % 4, .client = client}, 0);
    waiting.remove(3);
    waiting.remove(1);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> left;
    for (const WaitingRequest& it : waiting)
        left.emplace_back(it.request.client, it.passed);
    CHECK(left == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 2}, {2, 1}, {4, 0}});
}

} // namespace
} // namespace ffgpu::timing
