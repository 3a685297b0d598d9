#include "model/timing/memory_statistics.h"

#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::array<const char*, LostCauses> LostMeanings{
    "without data: no request was waiting",
    "without data: the oldest request's bank closed or opened a row",
    "without data: tRRD or tFAW held back an activate",
    "without data: the cycle's command went to another bank than the oldest request's",
    "without data: between read and write",
    "without data: refresh",
    "without data: tCCD is longer than a burst",
    "without data: the order of requests had to be kept",
    "with data of a burst that nobody asked for"};

} // namespace

ClientStatistics::ClientStatistics() {
    for (std::size_t client = 0; client < Clients; ++client)
        clients_.push_back(of_client("memory_" + std::string(ClientNames[client]) + '_'));
}

ClientStatistics::OfClient ClientStatistics::of_client(const std::string& prefix) {
    OfClient of{
        .read_bytes = &add(prefix + "read_bytes", "bytes", "read for this client"),
        .written_bytes = &add(prefix + "written_bytes", "bytes", "written for this client"),
        .requests = &add(prefix + "requests", "requests", "reads and writes of this client"),
        .latency = &add(prefix + "read_latency_cycles",
                        "cycles",
                        "sum over its reads, from the client's request to its data"),
        .write_latency = &add(prefix + "write_latency_cycles",
                              "cycles",
                              "sum over its writes, from the client's request to its end"),
        .read_latencies = {prefix + "read_latency", "reads", "by latency in cycles, doubling"},
        .write_latencies = {prefix + "write_latency", "writes", "by latency in cycles, doubling"}};
    for (unsigned i = 0; i < Buckets; ++i) {
        const bool last = i + 1 == Buckets;
        const unsigned limit = 1u << (FirstBucket + i - (last ? 1 : 0));
        of.histogram[i] =
            &add(prefix + "read_latency_" +
                     (last ? std::to_string(limit) + "_or_more" : "below_" + std::to_string(limit)),
                 "reads",
                 "by latency in cycles, each read in one of the ranges");
    }
    return of;
}

void ClientStatistics::count_done() {
    for (std::size_t client = 0; client < Clients; ++client) {
        OfClient& of = clients_[client];
        for (const bool write : {false, true}) {
            Done& done = done_[client][write];
            *(write ? of.written_bytes : of.read_bytes) += done.bytes;
            *(write ? of.write_latency : of.latency) += done.latency;
            for (unsigned width = 0; width < done.by_width.size(); ++width) {
                const std::uint64_t times = done.by_width[width];
                if (times == 0) continue;
                *of.requests += times;
                (write ? of.write_latencies : of.read_latencies).add(width, times);
                if (!write) *of.histogram[bucket_of(width)] += times;
            }
            done = {};
        }
    }
}

std::vector<const Histogram*> ClientStatistics::histograms() const {
    std::vector<const Histogram*> histograms;
    for (const OfClient& of : clients_)
        histograms.insert(histograms.end(), {&of.read_latencies, &of.write_latencies});
    return histograms;
}

DramStatistics::DramStatistics(const MemoryConfig& config, bool when_asked)
    : when_asked_(when_asked)
    , accesses_(config.channels * Clients) {
    for (std::size_t i = 0; i < LostCauses; ++i)
        lost_[i] = &add("memory_lost_" + std::string(LostToNames[i]) + "_cycles",
                        "memory cycles",
                        LostMeanings[i]);
    total_ = rows("memory_");
    for (std::size_t client = 0; client < Clients; ++client)
        of_client_[client] = rows("memory_" + std::string(ClientNames[client]) + '_');
    for (std::uint32_t channel = 0; channel < config.channels; ++channel)
        of_channel_.push_back(rows("memory_channel" + std::to_string(channel) + '_'));
}

DramStatistics::Rows DramStatistics::rows(const std::string& prefix) {
    return {&add(prefix + "row_hits", "requests", "that found their row open"),
            &add(prefix + "row_misses", "requests", "that found no row open in their bank"),
            &add(prefix + "row_conflicts", "requests", "that had to close another row")};
}

void DramStatistics::count_rows(std::size_t place, std::size_t result, std::uint64_t times) {
    *total_[result] += times;
    *of_client_[place % Clients][result] += times;
    *of_channel_[place / Clients][result] += times;
}

void DramStatistics::count_accesses() {
    for (std::size_t place = 0; place < accesses_.size(); ++place)
        for (std::size_t result = 0; result < accesses_[place].size(); ++result)
            count_rows(place, result, std::exchange(accesses_[place][result], 0));
}

} // namespace ffgpu::timing
