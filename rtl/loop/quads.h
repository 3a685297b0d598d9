// Quads of a batch as the bundles that units take, and what comes back.

#pragma once

#include "model/fragment/lane_access.h"
#include "rtl/bundles/quad.h"
#include "rtl/loop/loop_log.h"

#include <span>

namespace ffgpu::rtl {

// Of the registers of a batch: both banks have a part in a picture.
inline unsigned bank_of(const FragmentBatch& batch) {
    return batch.x[0] >> 1 & 1;
}

inline std::uint32_t packed_color(const ColorPlanes& planes, unsigned lane) {
    return pack_rgba8(lane_color(planes, lane));
}

// `color`: the running colour.
inline Quad quad_of(const FragmentBatch& batch, unsigned q, const ColorPlanes& color) {
    Quad quad{.primitive = batch.primitive[q],
              .x = batch.x[q],
              .y = batch.y[q],
              .live = static_cast<std::uint8_t>(batch.live.quad(q)),
              .front_facing = lane_front_facing(batch, 4 * q)};
    for (unsigned i = 0; i < Lanes; ++i) {
        const unsigned lane = Lanes * q + i;
        quad.depth[i] = batch.depth[lane] & 0xffffff;
        quad.coverage[i] = static_cast<std::uint8_t>(batch.antialias[lane]);
        quad.color[i] = packed_color(color, lane);
    }
    return quad;
}

inline const Quad& quad_in(const Quad& quad) {
    return quad;
}
inline const Quad& quad_in(const ShadeQuad& shaded) {
    return shaded.quad;
}
inline const Quad& quad_in(const WrittenQuad& written) {
    return written.quad;
}

// batch.color has the model's colours, and gets the unit's.
template <class Output>
void take_colors(const char* unit, std::span<const Output> outputs, FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        const std::uint32_t got = quad_in(outputs[lane / Lanes]).color[lane % Lanes];
        if (batch.live.test(lane))
            compare_lane(at_lane(unit, batch, lane), "color", packed_color(batch.color, lane), got);
        set_lane_color(batch.color, lane, unpack_rgba8(got));
    }
    loop_log().count(unit, "", batch.live.count());
}

// What is left of the live lanes; `expected` is what the model leaves.
template <class Output>
FragmentMask take_live(const char* unit,
                       std::span<const Output> outputs,
                       const FragmentBatch& batch,
                       const FragmentMask& expected) {
    FragmentMask left;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        const bool lives = quad_in(outputs[lane / Lanes]).is_live(lane % Lanes);
        if (batch.live.test(lane))
            compare_lane(at_lane(unit, batch, lane), "live", expected.test(lane), lives);
        if (lives) left.set(lane);
    }
    return left & batch.live;
}

} // namespace ffgpu::rtl
