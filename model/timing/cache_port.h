// CachePort: a cache with its way to memory and back.

#pragma once

#include "model/timing/config.h"
#include "model/timing/line_cache.h"
#include "model/timing/request_port.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace ffgpu::timing {

inline constexpr std::size_t ResponseQueue = 256; // and as many as a cache may have outstanding

struct CachePort {
    CachePort(std::string_view cache_name,
              const Clock& clock,
              const CacheConfig& config,
              Client client,
              InFlight& in_flight,
              Cycle response_latency = 1)
        : name(cache_name)
        , requests(clock, config.request_queue, in_flight, config.miss_queue)
        , responses(clock, ResponseQueue + config.outstanding_lines, response_latency)
        , cache(cache_name, config, client, requests) {}

    // The cache's owner, and what answers it.
    void connect(Unit& owner, Unit& memory) {
        requests.channel().connect(name + "_requests", owner, memory);
        responses.connect(name + "_responses", memory, owner);
    }

    const std::string name;
    RequestPort requests;
    Channel<std::uint64_t> responses;
    LineCache cache;
};

} // namespace ffgpu::timing
