// TextureShare: how the texture units of a fragment pipe share the work of one quad: which lines
// each looks up, in what order the pipe's look-ups follow each other, and how long the filters
// take.
//
//     cycles = max(1, max over units u of ceil(S(u) / bilinear_quads_per_cycle))
//
// where S(u) are the bilinear samples of the textures u, u + units, u + 2 units ...; with
// share = samples, S(u) = ceil(all samples / units). A texture's samples are the most that one of
// the quad's fragments takes: 1 for nearest and bilinear, 2 for trilinear, for each anisotropic
// probe; twice that for a texture of three dimensions that is filtered in depth.

#pragma once

#include "model/base/check.h"
#include "model/timing/config.h"
#include "model/timing/tokens.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::timing {

class TextureShare {
public:
    TextureShare(const TextureConfig& units, const TexelCacheConfig& cache)
        : units_(units.units)
        , lookups_(cache.lookups_per_cycle)
        , width_(cache.bilinear_quads_per_cycle)
        , by_texture_(units.share == UnitShare::Textures) {
        check(units_ <= MostUnits, "a counter for each texture unit");
    }

    // The next quad whose lines are looked up.
    void begin(const work::PreparedQuads& quads, const PreparedQuad& quad);
    bool is_done() const { return next_ == lines_; }

    void begin_cycle() { used_.fill(0); }
    // The unit whose line is next has a look-up left in this cycle.
    bool has_turn() const { return used_[unit()] < lookups_; }
    // The quad's line that is looked up next. The order is the same whatever look-ups are refused.
    std::size_t line() const { return order_.empty() ? next_ : order_[next_].line; }
    void advance() {
        ++used_[unit()];
        ++next_;
    }

    std::uint32_t filter_cycles(const work::PreparedQuads& quads, const PreparedQuad& quad) const;

private:
    static constexpr std::size_t MostUnits = 8;

    struct Lookup {
        std::size_t line = 0;
        std::size_t unit = 0;
    };

    std::size_t unit() const { return order_.empty() ? 0 : order_[next_].unit; }

    std::size_t units_;
    std::size_t lookups_; // of a unit and cycle
    std::uint32_t width_; // bilinear samples of a unit and cycle
    bool by_texture_;
    std::size_t lines_ = 0, next_ = 0;
    std::array<std::size_t, MostUnits> used_{}; // look-ups of each unit in this cycle
    // Several units: the quad's lines, in turns of as many as a unit looks up in a cycle.
    std::vector<Lookup> order_;
    std::vector<std::vector<std::size_t>> of_unit_;
};

} // namespace ffgpu::timing
