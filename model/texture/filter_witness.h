// What the filters of the scalar specification share: the fragment that is sampled, and who is told
// of the texels that are read for it.

#pragma once

#include "model/packets/texel_footprint.h"
#include "model/texture/coordinates.h"
#include "model/texture/filter.h"
#include "model/texture/texture_unit.h"

#include <array>
#include <cstdint>

namespace ffgpu {

struct SampledFragment {
    TexCoord coord; // of cube maps: on the face
    unsigned face = 0;
    std::uint32_t reference = 0; // depth to compare with
};

// Where reads and accesses are told; both may be null.
struct FilterWitness {
    TexelObserver* observer = nullptr;
    TexelFootprints* footprints = nullptr;
    unsigned lane = 0;
    std::uint32_t probe_weight = 1; // of the next probe, in the mean of all

    FilterWitness weighted(std::uint32_t weight) const {
        return {observer, footprints, lane, weight};
    }

    void begin_probe(const SampledFragment& at, std::uint8_t next_level = 0) const {
        if (observer) observer->probe(lane, at.face, at.coord, {probe_weight, next_level});
    }

    const Rgba& told(unsigned axis, const Rgba& color) const {
        if (observer) observer->filtered(axis, color);
        return color;
    }

    void tell(const TexelAccess& access, const std::array<AxisTexels, 3>& axes) const {
        if (footprints) footprints->add(access);
        if (observer) observer->level(access, axes);
    }
};

} // namespace ffgpu
