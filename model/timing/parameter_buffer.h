// ParameterBuffer: where a pass's headers, records and lists lie in memory, and the requests that
// move them. Each of the parameter buffers is filled from its beginning: records, headers, then the
// lists, one behind the other.

#pragma once

#include "model/timing/memory_request.h"
#include "model/timing/tile_tokens.h"
#include "model/work/tile_config.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace ffgpu::timing {

struct ParameterBytes {
    std::uint64_t address = 0;
    std::uint32_t bytes = 0;
};

class ParameterBuffer {
public:
    // No request is longer, or crosses a multiple of it: the least interleave of channels.
    static constexpr std::uint32_t RequestBytes = 64;

    ParameterBuffer(const work::TileOrder& config, const PassToken& pass);

    ParameterBytes record(std::uint32_t record) const;
    ParameterBytes header(std::uint32_t bin) const;
    // Of the entries [begin, end) of the bin's list.
    ParameterBytes entries(std::uint32_t bin, std::uint32_t begin, std::uint32_t end) const;

private:
    const work::TileOrder* config_;
    const work::TilePlan* plan_;
    const work::TilePass* pass_;
    std::uint64_t base_;
};

// Cuts bytes into requests.
void add_requests(const ParameterBytes& bytes, bool write, std::deque<MemoryRequest>& requests);

} // namespace ffgpu::timing
