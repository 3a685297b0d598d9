// Look-ups: what the units ask of their caches, in the order in which an immediate machine with one
// pipe asks, without a clock; what is thrown out of the caches in between; and in which quad,
// triangle, draw and frame each look-up stands.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ffgpu::work {

enum class LookupClient : std::uint8_t { Texel, Depth, Color, Vertex };
inline constexpr std::array<std::string_view, 4> LookupClientNames{
    "texel", "depth", "color", "vertex"};

// Where a line was looked up last, seen from its next look-up: the narrowest that holds both. Of
// vertices the first three are one vertex.
enum class Reuse : std::uint8_t { Quad, Tile, Primitive, Draw, Frame, EarlierFrame };
inline constexpr std::size_t ReuseScopes = 5; // that begin and end: all but the last
inline constexpr std::array<std::string_view, ReuseScopes + 1> ReuseNames{
    "quad", "tile", "primitive", "draw", "frame", "earlier_frame"};

// The quad, or vertex, that asks: they are numbered in their order from 0, those of all caches of
// fragments together. A tile is one of the rasterizer's, of one piece; a tile-based machine's
// primitives and draws are their parts in a bin.
struct LookupPlace {
    std::uint64_t number = 0;
    std::array<std::uint64_t, ReuseScopes> began{}; // the first of each scope that holds it
    std::uint16_t x = 0, y = 0;                     // of a quad: window pixel of lane 0

    // A scope begins here, and all narrower ones do.
    void begin(Reuse scope) {
        for (std::size_t i = 0; i <= static_cast<std::size_t>(scope); ++i)
            began[i] = number;
    }
    Reuse since(std::uint64_t last) const {
        std::size_t scope = 0; // A wider one began before, or with it: no branch.
        for (const std::uint64_t first : began)
            scope += last < first;
        return static_cast<Reuse>(scope);
    }
};

struct LineLookup {
    std::uint64_t line = 0; // its number; of texels as texel_line.h has it
    bool write = false;

    bool operator==(const LineLookup&) const = default;
};

// A line whose memory changes behind the cache, which forgets it. What is dirty of it is written
// first, unless all of the line is overwritten.
struct OverwrittenLine {
    std::uint64_t line = 0;
    bool whole = false;

    bool operator==(const OverwrittenLine&) const = default;
};

class LookupSink {
public:
    virtual ~LookupSink() = default;

    // Of one quad or vertex. `reads`: texels, samples or vertices that they serve.
    virtual void lookups(LookupClient client,
                         const LookupPlace& place,
                         std::span<const LineLookup> lines,
                         std::uint32_t reads) = 0;
    // Of a quad that reads the texels' `lines` which the quad told last did, and is of its tile.
    virtual void
    same_lookups(const LookupPlace& place, std::span<const LineLookup> lines, std::uint32_t reads) {
        lookups(LookupClient::Texel, place, lines, reads);
    }
    // All lines are forgotten; the dirty ones are written back.
    virtual void flush(LookupClient client) = 0;
    // In rising order.
    virtual void overwritten(LookupClient client, std::span<const OverwrittenLine> lines) = 0;
    virtual void end_frame(std::uint32_t frame) = 0;
};

// The texels of these lines changed, which are in rising order: caches only read them, and forget
// them whole.
inline void tell_rewritten(std::span<const std::uint64_t> lines, LookupSink& sink) {
    std::vector<OverwrittenLine> overwritten;
    overwritten.reserve(lines.size());
    for (const std::uint64_t line : lines)
        overwritten.push_back({line, true});
    if (!overwritten.empty()) sink.overwritten(LookupClient::Texel, overwritten);
}

} // namespace ffgpu::work
