// What the memory's reports are made of: per client what it asked for and how long it waited, per
// channel and client what the rows did, and where the buses' cycles went.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/histogram.h"
#include "model/timing/memory/config.h"
#include "model/timing/memory/dram_request.h"
#include "model/timing/memory_request.h"

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <string>
#include <vector>

namespace ffgpu::timing {

class NamedStatistics : public StatisticsGroup {
protected:
    // The name is kept here: a Counter keeps views.
    Counter& add(std::string name, const char* unit, const char* meaning) {
        return count(names_.emplace_back(std::move(name)), unit, meaning);
    }

private:
    std::deque<std::string> names_;
};

// Of requests that are done, whatever memory did them.
class ClientStatistics : public NamedStatistics {
public:
    ClientStatistics();
    void on_done(const MemoryRequest& request, std::uint64_t now) {
        const std::uint64_t latency = now - request.issued;
        Done& done = done_[static_cast<std::size_t>(request.client)][request.write];
        done.bytes += request.bytes;
        done.latency += latency;
        ++done.by_width[Histogram::doubling(latency)];
    }
    // The counters and histograms know of all of them then.
    void count_done();

    std::vector<const Histogram*> histograms() const;

    // Latencies of reads are counted below 2^5, 2^6 ... 2^10 cycles, and above.
    static constexpr unsigned FirstBucket = 5;
    static constexpr unsigned Buckets = 7;
    static unsigned bucket(std::uint64_t cycles) {
        return bucket_of(static_cast<unsigned>(std::bit_width(cycles)));
    }
    // By the bits of the number of cycles.
    static unsigned bucket_of(unsigned width) {
        return width <= FirstBucket ? 0 : std::min(width - FirstBucket, Buckets - 1);
    }

private:
    struct OfClient {
        Counter *read_bytes, *written_bytes, *requests, *latency, *write_latency;
        Histogram read_latencies, write_latencies;
        std::array<Counter*, Buckets> histogram{};
    };
    OfClient of_client(const std::string& prefix);

    struct Done {
        std::uint64_t bytes = 0, latency = 0;
        std::array<std::uint64_t, 65> by_width{}; // requests, by the bits of their latency
    };

    std::vector<OfClient> clients_;
    std::array<std::array<Done, 2>, Clients> done_{}; // not counted yet: reads, writes
};

class DramStatistics : public NamedStatistics, public DramObserver {
public:
    // `when_asked`: requests are counted by count_accesses(), which its owner calls then; else at
    // once.
    explicit DramStatistics(const MemoryConfig& config, bool when_asked = false);

    void on_access(std::uint32_t channel, const DramRequest& request, RowResult result) override {
        const std::size_t place = channel * Clients + request.client;
        const auto did = static_cast<std::size_t>(result);
        if (when_asked_)
            ++accesses_[place][did];
        else
            count_rows(place, did, 1);
    }
    // The counters know of all of them then.
    void count_accesses();
    void on_data(MemoryCycle cycles) override { data_cycles_ += cycles; }
    void on_lost(LostTo cause, MemoryCycle cycles) override {
        *lost_[static_cast<std::size_t>(cause)] += cycles;
    }
    void on_turnaround() override { ++turnarounds_; }
    void on_refresh() override { ++refreshes_; }
    // The machine's cycles of all channels up to now.
    void set_bus_cycles(MemoryCycle cycles) { bus_cycles_ += cycles - bus_cycles_.value(); }

private:
    using Rows = std::array<Counter*, static_cast<std::size_t>(RowResult::Count)>;
    Rows rows(const std::string& prefix);
    // Of the channel's client with this place in accesses_.
    void count_rows(std::size_t place, std::size_t result, std::uint64_t times);

    const bool when_asked_;

    Counter& bus_cycles_ = count(
        "memory_bus_cycles", "memory cycles", "of all channels: data and lost ones add up to it");
    Counter& data_cycles_ =
        count("memory_data_cycles", "memory cycles", "in which a bus carried what was asked for");
    std::array<Counter*, LostCauses> lost_;
    Counter& turnarounds_ =
        count("memory_turnarounds", "changes", "of a bus between read and write");
    Counter& refreshes_ = count("memory_refreshes", "refreshes", "of all banks of a channel");
    Rows total_;
    std::array<Rows, Clients> of_client_;
    std::vector<Rows> of_channel_;
    // Not counted yet: of each channel's clients, by what the row did.
    std::vector<std::array<std::uint64_t, static_cast<std::size_t>(RowResult::Count)>> accesses_;
};

} // namespace ffgpu::timing
