// What the memory's reports are made of: per client what it asked for and how long it waited, per
// channel and client what the rows did, and where the buses' cycles went.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/histogram.h"
#include "model/timing/memory/config.h"
#include "model/timing/memory/dram_request.h"
#include "model/timing/memory_request.h"

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
    void on_done(const MemoryRequest& request, std::uint64_t now);

    std::vector<const Histogram*> histograms() const;

    // Latencies of reads are counted below 2^5, 2^6 ... 2^10 cycles, and above.
    static constexpr unsigned FirstBucket = 5;
    static constexpr unsigned Buckets = 7;
    static unsigned bucket(std::uint64_t cycles) {
        const auto width = static_cast<unsigned>(std::bit_width(cycles));
        return width <= FirstBucket ? 0 : std::min(width - FirstBucket, Buckets - 1);
    }

private:
    struct OfClient {
        Counter *read_bytes, *written_bytes, *requests, *latency, *write_latency;
        Histogram read_latencies, write_latencies;
        std::array<Counter*, Buckets> histogram{};
    };
    OfClient of_client(const std::string& prefix);

    std::vector<OfClient> clients_;
};

class DramStatistics : public NamedStatistics, public DramObserver {
public:
    explicit DramStatistics(const MemoryConfig& config);

    void on_access(std::uint32_t channel, const DramRequest& request, RowResult result) override;
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
};

} // namespace ffgpu::timing
