// One cache with its port to memory, without units: what it asks of memory, and when it takes a
// look-up.

#include "model/timing/line_cache.h"
#include "tests/timing/bench_clock.h"

#include <bit>
#include <map>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

CacheConfig tiny(std::uint32_t sets, std::uint32_t ways) {
    CacheConfig config;
    config.sets = sets;
    config.ways = ways;
    return config;
}

struct Bench : BenchClock {
    explicit Bench(const CacheConfig& config)
        : in_flight(clock)
        , requests(clock, config.request_queue, in_flight, config.miss_queue)
        , responses(clock, 4096)
        , cache("cache", config, Client::Color, requests) {
        run(1);
    }

    // Takes what waits for the arbiter.
    std::vector<MemoryRequest> take() {
        std::vector<MemoryRequest> taken;
        run(1);
        for (; requests.channel().can_pop(); in_flight.leave())
            taken.push_back(requests.channel().pop());
        return taken;
    }
    // A new cycle.
    void begin() {
        run(1);
        cache.begin_cycle(responses);
    }
    // Looks up when the cache lets it; the memory answers at once.
    LookupResult look_up(const LineAccess& access) {
        for (;;) {
            const LookupResult result = cache.look_up(access);
            serve();
            if (result.accepted) return result;
        }
    }
    void serve() {
        last_served = take();
        for (const MemoryRequest& request : last_served) {
            (request.write ? written : fetched) += request.bytes;
            if (!request.write) cache.complete(request.ticket);
        }
        begin();
    }

    InFlight in_flight;
    RequestPort requests;
    Channel<std::uint64_t> responses;
    LineCache cache;
    std::uint64_t fetched = 0, written = 0;
    std::vector<MemoryRequest> last_served;
};

// Bytes [begin, end) of a line of 64.
LineMask bytes(unsigned begin, unsigned end) {
    LineMask mask = 0;
    for (unsigned i = begin; i < end; ++i)
        mask |= LineMask{1} << i;
    return mask;
}

LineAccess write_of(std::uint64_t number, LineMask mask) {
    return {.number = number, .read = 0, .written = mask, .covered = mask};
}

TEST_CASE("hits are served while fills are at their limit, misses are not") {
    CacheConfig config = tiny(4, 4);
    config.outstanding_lines = 2;
    config.miss_queue = 4;
    Bench bench(config);
    CHECK(bench.cache.look_up({.number = 1}).missed);
    CHECK(bench.cache.look_up({.number = 2}).missed);
    CHECK_FALSE(bench.cache.look_up({.number = 3}).accepted);
    for (std::uint64_t i = 0; i < 5; ++i) {
        const LookupResult hit = bench.cache.look_up({.number = 1 + i % 2});
        CHECK(hit.accepted);
        CHECK_FALSE(hit.missed);
    }
    CHECK(bench.cache.statistics().under_miss.value() == 5);
    CHECK(bench.cache.statistics().accesses.value() == 7);
    bench.cache.complete(1);
    CHECK(bench.cache.look_up({.number = 3}).missed);
}

TEST_CASE("a present line that lacks what is read waits for a fill as a miss does") {
    CacheConfig config = tiny(4, 4);
    config.outstanding_lines = 1;
    Bench bench(config);
    CHECK(bench.cache.look_up(write_of(1, bytes(0, 8))).accepted);
    CHECK(bench.cache.look_up({.number = 2}).missed);
    CHECK(bench.cache.look_up({.number = 1, .read = bytes(0, 8)}).accepted);
    CHECK_FALSE(bench.cache.look_up({.number = 1, .read = bytes(0, 9)}).accepted);
    CHECK(bench.cache.statistics().partial_fetches.value() == 0);
    CHECK(bench.cache.statistics().accesses.value() == 3);
    bench.cache.complete(1);
    CHECK(bench.cache.look_up({.number = 1, .read = bytes(0, 9)}).ticket == 2);
}

TEST_CASE("a present line that lacks what is read waits for a place in the miss queue") {
    CacheConfig config = tiny(4, 4);
    config.request_queue = 1;
    config.miss_queue = 1;
    Bench bench(config);
    CHECK(bench.cache.look_up(write_of(1, bytes(0, 8))).accepted);
    CHECK(bench.cache.look_up({.number = 2}).missed);
    CHECK(bench.cache.look_up({.number = 3}).missed);
    CHECK_FALSE(bench.cache.look_up({.number = 1}).accepted);
    // What only writes posts the line that it drives out.
    CHECK_FALSE(bench.cache.look_up(write_of(4, bytes(0, 8))).accepted);
    CHECK(bench.take().size() == 1);
    bench.begin();
    CHECK(bench.cache.look_up({.number = 1}).ticket == 3);
}

TEST_CASE("a write that fetches nothing needs no fill") {
    CacheConfig config = tiny(4, 4);
    config.outstanding_lines = 1;
    Bench bench(config);
    CHECK(bench.cache.look_up({.number = 1}).missed);
    CHECK(bench.cache.look_up(write_of(2, bytes(0, 4))).accepted);
    CHECK_FALSE(bench.cache.look_up({.number = 3}).accepted);
}

TEST_CASE("the request queue fills first, then the miss queue, then misses wait") {
    for (const auto& [requests, misses] : {std::pair{1u, 1u}, {1u, 3u}, {16u, 1u}, {4u, 5u}}) {
        CacheConfig config = tiny(64, 4);
        config.request_queue = requests;
        config.miss_queue = misses;
        Bench bench(config);
        std::uint32_t accepted = 0;
        while (bench.cache.look_up({.number = accepted}).accepted)
            ++accepted;
        INFO(requests << " requests, " << misses << " misses");
        CHECK(accepted == requests + misses);
        CHECK(bench.cache.look_up({.number = 0}).accepted);
        CHECK(bench.take().size() == requests);
        bench.begin();
        CHECK(bench.cache.look_up({.number = 1000}).accepted);
    }
}

TEST_CASE("a write-back and its fill pass through a request queue of one, in order") {
    CacheConfig config = tiny(1, 1);
    config.request_queue = 1;
    Bench bench(config);
    CHECK(bench.cache.look_up(write_of(1, bytes(0, 64))).accepted);
    CHECK(bench.cache.look_up({.number = 2}).missed);
    const auto first = bench.take();
    bench.begin();
    const auto second = bench.take();
    REQUIRE(first.size() == 1);
    REQUIRE(second.size() == 1);
    CHECK(first[0].write);
    CHECK(first[0].address == 64);
    CHECK_FALSE(second[0].write);
    CHECK(second[0].address == 128);
}

TEST_CASE("a miss that writes a line back takes one place of the miss queue, not two") {
    CacheConfig config = tiny(1, 8);
    config.request_queue = 1;
    config.miss_queue = 3;
    Bench bench(config);
    for (std::uint64_t number = 0; number < 8; ++number)
        bench.look_up(write_of(number, bytes(0, 64)));
    std::uint64_t accepted = 0;
    while (accepted < 8 && bench.cache.look_up({.number = 8 + accepted}).accepted)
        ++accepted;
    CHECK(accepted == 3); // Each with a fill that waits behind the first one's write.
}

TEST_CASE("a bank serves as many look-ups a cycle as it has ports") {
    for (const std::uint32_t banks : {1u, 2u, 8u}) {
        for (const std::uint32_t ports : {1u, 2u, 3u}) {
            CacheConfig config = tiny(64, 4);
            config.banks = banks;
            config.ports = ports;
            config.miss_queue = 64;
            Bench bench(config);
            INFO(banks << " banks, " << ports << " ports");
            for (std::uint32_t i = 0; i < banks * ports; ++i)
                CHECK(bench.cache.look_up({.number = i}).accepted);
            CHECK_FALSE(bench.cache.look_up({.number = 0}).accepted);
            CHECK(bench.cache.statistics().bank_conflicts.value() == 1);
            bench.begin();
            CHECK(bench.cache.look_up({.number = 0}).accepted);
        }
    }
}

TEST_CASE("a stride of the banks takes a cycle a look-up and port, a stride of one does not") {
    const auto cycles = [](std::uint64_t stride) {
        CacheConfig config = tiny(64, 4);
        config.banks = 4;
        config.ports = 1;
        config.miss_queue = 64;
        config.request_queue = 64;
        Bench bench(config);
        Cycle begun = bench.clock.now();
        for (std::uint64_t i = 0; i < 64; ++i) {
            while (!bench.cache.look_up({.number = i * stride}).accepted)
                bench.begin();
        }
        return bench.clock.now() - begun + 1;
    };
    CHECK(cycles(1) == 64 / 4);
    CHECK(cycles(2) == 64 / 2);
    CHECK(cycles(4) == 64);
}

TEST_CASE("write-validate writes what was dirtied, in pieces of transfer_bytes") {
    for (const auto& [piece, moved] : {std::pair{1u, 6u}, {4u, 12u}, {16u, 32u}, {64u, 64u}}) {
        CacheConfig config = tiny(4, 1);
        config.transfer_bytes = piece;
        Bench bench(config);
        // Bytes 2-4 touch two words of four, 40-42 one.
        CHECK(bench.look_up(write_of(4, bytes(2, 5) | bytes(40, 43))).missed);
        CHECK(bench.fetched == 0);
        CHECK(bench.look_up({.number = 8}).missed);
        INFO("pieces of " << piece);
        CHECK(bench.written == moved);
        CHECK(bench.cache.statistics().dirtied_bytes.value() == 6);
    }
}

TEST_CASE("a read of bytes that a partly written line lacks fetches it, and keeps what is dirty") {
    Bench bench(tiny(4, 1));
    bench.look_up(write_of(4, bytes(0, 8)));
    const LookupResult inside = bench.look_up({.number = 4, .read = bytes(4, 8)});
    CHECK_FALSE(inside.missed);
    CHECK(bench.fetched == 0);
    const LookupResult outside = bench.look_up({.number = 4, .read = bytes(4, 9)});
    CHECK_FALSE(outside.missed);
    CHECK(outside.ticket == 1);
    CHECK(bench.fetched == 64);
    bench.look_up({.number = 4});
    CHECK(bench.fetched == 64);
    CHECK(bench.cache.statistics().partial_fetches.value() == 1);
    bench.look_up({.number = 8});
    CHECK(bench.written == 8);
}

TEST_CASE("fetch-on-write fetches lines that are not wholly written") {
    CacheConfig config = tiny(4, 1);
    config.write_miss = WriteMiss::FetchOnWrite;
    Bench bench(config);
    bench.look_up(write_of(1, bytes(0, 64)));
    CHECK(bench.fetched == 0);
    bench.look_up(write_of(2, bytes(0, 63)));
    CHECK(bench.fetched == 64);
}

TEST_CASE("bits of several bytes that are written in part are fetched") {
    CacheConfig config = tiny(4, 1);
    config.line_bytes = 256; // Four bytes a bit.
    Bench bench(config);
    const work::LineGrain grain(256);
    const auto write = [&](std::uint64_t number, std::uint32_t begin, std::uint32_t end) {
        bench.look_up({.number = number,
                       .read = 0,
                       .written = grain.touched(begin, end),
                       .covered = grain.covered(begin, end)});
    };
    write(0, 8, 16);
    CHECK(bench.fetched == 0);
    write(1, 8, 15);
    CHECK(bench.fetched == 256);
}

TEST_CASE("an overwritten line is dropped, one that is overwritten in part is written first") {
    Bench bench(tiny(4, 4));
    for (const std::uint64_t number : {1u, 2u, 3u})
        bench.look_up(write_of(number, bytes(0, 32)));
    CHECK(bench.cache.overwrite(1, bytes(0, 64)).bytes == 0);
    CHECK(bench.cache.overwrite(2, bytes(0, 63)).bytes == 32);
    CHECK(bench.cache.overwrite(9, bytes(0, 1)).bytes == 0);
    CHECK(bench.cache.flush().size() == 1);
    CHECK(bench.cache.statistics().dropped_bytes.value() == 32);
    CHECK(bench.cache.statistics().written_bytes.value() == 64);
}

TEST_CASE("lines that came one behind the other are written back so, whatever the ways") {
    for (const std::uint32_t ways : {1u, 2u, 8u, 16u}) {
        Bench bench(tiny(16 / ways, ways));
        for (std::uint64_t number = 32; number < 48; ++number)
            bench.look_up(write_of(number, bytes(0, 64)));
        std::uint64_t next = 32;
        for (const LineWrite& line : bench.cache.flush())
            CHECK(line.number == next++);
        CHECK(next == 48);
    }
}

TEST_CASE("invalidated lines miss again, their neighbours do not") {
    Bench bench(tiny(4, 4));
    for (std::uint64_t number = 0; number < 8; ++number)
        bench.look_up({.number = number});
    bench.cache.invalidate(2 * 64 + 63, 4 * 64 + 1); // a byte of lines 2 and 4, all of 3
    for (std::uint64_t number = 0; number < 8; ++number)
        CHECK(bench.look_up({.number = number}).missed == (number >= 2 && number <= 4));
    bench.cache.invalidate(64, 64);
    CHECK_FALSE(bench.look_up({.number = 1}).missed);
    CHECK(bench.cache.statistics().compulsory.value() == 11);
}

// What memory and the cache must hold, kept by line by the test alone.
struct ByteModel {
    std::map<std::uint64_t, LineMask> dirty, valid;

    void served(const MemoryRequest& request, std::uint64_t missed_line) {
        const std::uint64_t line = request.address / 64;
        if (request.write) {
            CHECK(request.bytes == static_cast<unsigned>(std::popcount(dirty[line])));
            CHECK(request.bytes > 0);
            dirty[line] = 0;
        } else {
            CHECK(line == missed_line);
            CHECK(request.bytes == 64);
            valid[line] = ~LineMask{0};
        }
    }
    void looked_up(const LineAccess& access, const LookupResult& result, const Bench& bench) {
        const std::uint64_t line = access.number;
        if (result.missed) {
            CHECK(dirty[line] == 0); // Nothing that was written got lost.
            valid[line] = 0;
        }
        for (const MemoryRequest& request : bench.last_served)
            served(request, line);
        valid[line] |= access.written;
        dirty[line] |= access.written;
        CHECK((access.read & ~valid[line]) == 0);
    }
    void overwritten(std::uint64_t line, LineMask mask, std::uint32_t written_back) {
        const LineMask was = dirty[line];
        const bool all = mask == ~LineMask{0};
        CHECK(written_back == (all ? 0u : static_cast<unsigned>(std::popcount(was))));
        dirty[line] = 0;
    }
};

void check_sums(const CacheStatistics& s, bool fully_associative) {
    CHECK(s.hits.value() + s.misses.value() == s.accesses.value());
    CHECK(s.compulsory.value() + s.capacity.value() + s.conflict.value() == s.misses.value());
    CHECK(s.read_bytes.value() ==
          64 * (s.misses.value() - s.without_fetch.value() + s.partial_fetches.value()));
    CHECK(s.dirtied_bytes.value() == s.written_bytes.value() + s.dropped_bytes.value());
    if (fully_associative) CHECK(s.conflict.value() == 0);
}

TEST_CASE("dirty bytes in are bytes out, and no read finds bytes that nobody fetched or wrote") {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        CacheConfig config = tiny(1u << random() % 3, 1 + static_cast<std::uint32_t>(random() % 4));
        config.transfer_bytes = 1;
        config.replacement = static_cast<work::Replacement>(random() % 3);
        config.write_miss = static_cast<WriteMiss>(random() % 2);
        Bench bench(config);
        ByteModel model;
        for (int i = 0; i < 400; ++i) {
            const std::uint64_t line = random() % 24;
            const auto begin = static_cast<unsigned>(random() % 64);
            const auto end = begin + 1 + static_cast<unsigned>(random() % (64 - begin));
            const LineMask mask = random() % 8 ? bytes(begin, end) : ~LineMask{0};
            if (random() % 30 == 0) {
                model.overwritten(line, mask, bench.cache.overwrite(line, mask).bytes);
                continue;
            }
            const LineAccess access =
                random() % 2 ? write_of(line, mask) : LineAccess{.number = line, .read = mask};
            model.looked_up(access, bench.look_up(access), bench);
        }
        for (const LineWrite& line : bench.cache.flush())
            model.served({.address = line.number * 64, .bytes = line.bytes, .write = true}, 0);
        for (const auto& [line, mask] : model.dirty)
            CHECK(mask == 0);
        check_sums(bench.cache.statistics(), config.sets == 1);
    }
}

} // namespace
} // namespace ffgpu::timing
