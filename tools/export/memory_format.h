// The formats of memory traces: a request as the lines of each.

#pragma once

#include "model/timing/memory/config.h"
#include "model/timing/memory_request.h"
#include "model/timing/quad_observer.h"
#include "tools/export/text_writer.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace ffgpu::tools {

// A request, when it was sent to memory, and for whom, where that is known.
struct TracedRequest {
    timing::MemoryRequest request;
    std::uint64_t cycle = 0; // of the core's clock
    bool counts = true;      // It is in the statistics, or is sure to be.
    std::optional<timing::QuadName> quad{};
};

// The texture level that holds an address.
struct TexelPlace {
    std::uint64_t texture = 0; // the image's address in the device's memory
    std::uint32_t level = 0;
};

enum class MemoryTraceKind : std::uint8_t { Ramulator2, Ramulator2Vectors, Dramsim3, Dramsys, Csv };

struct MemoryFormatOptions {
    timing::MemoryConfig memory;
    std::uint32_t access_bytes = 64; // of a record in formats that do not tell sizes
    std::uint32_t tile_width = 8;
};

class MemoryFormat {
public:
    virtual ~MemoryFormat() = default;
    virtual void begin(TextWriter&) {}
    virtual void write(const TracedRequest& request,
                       const std::optional<TexelPlace>& place,
                       TextWriter& out) = 0;
};

std::unique_ptr<MemoryFormat> make_memory_format(MemoryTraceKind kind,
                                                 const MemoryFormatOptions& options);

} // namespace ffgpu::tools
