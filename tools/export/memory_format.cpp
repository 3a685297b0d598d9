#include "tools/export/memory_format.h"

#include "model/base/input_error.h"
#include "model/timing/memory/address_mapping.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using timing::MemoryConfig;

std::uint64_t memory_cycle(const MemoryConfig& memory, std::uint64_t cycle) {
    return cycle * memory.memory_clocks / memory.core_clocks;
}

// Calls each(address) for each record of `bytes` that the request takes, which begin at multiples.
template <class Each>
void for_each_access(const timing::MemoryRequest& request, std::uint32_t bytes, Each&& each) {
    const std::uint64_t end = request.address + request.bytes;
    for (std::uint64_t at = request.address / bytes * bytes; at < end; at += bytes)
        each(at);
}

// LoadStoreTrace: `LD 0x12340`.
class Ramulator2 final : public MemoryFormat {
public:
    explicit Ramulator2(const MemoryFormatOptions& options)
        : options_(options) {}

    void
    write(const TracedRequest& traced, const std::optional<TexelPlace>&, TextWriter& out) override {
        for_each_access(traced.request, options_.access_bytes, [&](std::uint64_t at) {
            out.print(FMT_COMPILE("{} 0x{:x}\n"), traced.request.write ? "ST" : "LD", at);
        });
    }

private:
    const MemoryFormatOptions options_;
};

// ReadWriteTrace: `R channel,rank,bank group,bank,row,column`. The machine's memory has one rank
// and one bank group; a column is a record's bytes.
class Ramulator2Vectors final : public MemoryFormat {
public:
    explicit Ramulator2Vectors(const MemoryFormatOptions& options)
        : options_(options) {
        const timing::MemoryConfig& memory = options.memory;
        const std::uint32_t together = memory.channels > 1
                                           ? std::min(memory.interleave_bytes, memory.row_bytes)
                                           : memory.row_bytes;
        if (options.access_bytes > together)
            throw InputError(fmt::format("--access-bytes {}: no more than {} bytes in a row lie in "
                                         "one channel's row, which a vector names",
                                         options.access_bytes,
                                         together));
    }

    void
    write(const TracedRequest& traced, const std::optional<TexelPlace>&, TextWriter& out) override {
        for_each_access(traced.request, options_.access_bytes, [&](std::uint64_t at) {
            const timing::DramPlace place = timing::place_of(options_.memory, at);
            out.print(FMT_COMPILE("{} {},0,0,{},{},{}\n"),
                      traced.request.write ? 'W' : 'R',
                      place.channel,
                      place.bank,
                      place.row,
                      timing::row_offset(options_.memory, at) / options_.access_bytes);
        });
    }

private:
    const MemoryFormatOptions options_;
};

// `0x2000D5C0 READ 30`: address, command, cycle of the memory's clock.
class Dramsim3 final : public MemoryFormat {
public:
    explicit Dramsim3(const MemoryFormatOptions& options)
        : options_(options) {}

    void
    write(const TracedRequest& traced, const std::optional<TexelPlace>&, TextWriter& out) override {
        for_each_access(traced.request, options_.access_bytes, [&](std::uint64_t at) {
            out.print(FMT_COMPILE("0x{:X} {} {}\n"),
                      at,
                      traced.request.write ? "WRITE" : "READ",
                      memory_cycle(options_.memory, traced.cycle));
        });
    }

private:
    const MemoryFormatOptions options_;
};

// `31:	(64) read	0x40`: cycle of the memory's clock, bytes, command, address.
class Dramsys final : public MemoryFormat {
public:
    explicit Dramsys(const MemoryFormatOptions& options)
        : options_(options) {}

    void
    write(const TracedRequest& traced, const std::optional<TexelPlace>&, TextWriter& out) override {
        out.print(FMT_COMPILE("{}:\t({}) {}\t0x{:x}\n"),
                  memory_cycle(options_.memory, traced.cycle),
                  traced.request.bytes,
                  traced.request.write ? "write" : "read",
                  traced.request.address);
    }

private:
    const MemoryFormatOptions options_;
};

class Csv final : public MemoryFormat {
public:
    explicit Csv(const MemoryFormatOptions& options)
        : options_(options) {}

    void begin(TextWriter& out) override {
        out.print(FMT_COMPILE(
            "cycle,unit,operation,address,bytes,draw,primitive,texture,level,tile,x,y\n"));
    }

    void write(const TracedRequest& traced,
               const std::optional<TexelPlace>& place,
               TextWriter& out) override {
        const timing::MemoryRequest& request = traced.request;
        out.print(FMT_COMPILE("{},{},{},0x{:x},{},"),
                  traced.cycle,
                  timing::ClientNames[static_cast<std::size_t>(request.client)],
                  request.write ? "write" : "read",
                  request.address,
                  request.bytes);
        if (traced.quad)
            out.print(FMT_COMPILE("{},{},"), traced.quad->draw, traced.quad->primitive);
        else
            out.print(FMT_COMPILE(",,"));
        if (place)
            out.print(FMT_COMPILE("0x{:x},{},"), place->texture, place->level);
        else
            out.print(FMT_COMPILE(",,"));
        if (traced.quad)
            out.print(FMT_COMPILE("{}:{},{},{}\n"),
                      traced.quad->x / options_.tile_width,
                      traced.quad->y / options_.tile_width,
                      traced.quad->x,
                      traced.quad->y);
        else
            out.print(FMT_COMPILE(",,\n"));
    }

private:
    const MemoryFormatOptions options_;
};

} // namespace

std::unique_ptr<MemoryFormat> make_memory_format(MemoryTraceKind kind,
                                                 const MemoryFormatOptions& options) {
    switch (kind) {
    case MemoryTraceKind::Ramulator2:
        return std::make_unique<Ramulator2>(options);
    case MemoryTraceKind::Ramulator2Vectors:
        return std::make_unique<Ramulator2Vectors>(options);
    case MemoryTraceKind::Dramsim3:
        return std::make_unique<Dramsim3>(options);
    case MemoryTraceKind::Dramsys:
        return std::make_unique<Dramsys>(options);
    case MemoryTraceKind::Csv:
        break;
    }
    return std::make_unique<Csv>(options);
}

} // namespace ffgpu::tools
