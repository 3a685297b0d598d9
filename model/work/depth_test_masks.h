// Where a machine tests a draw's depth, and which fragments come to its tests and leave them.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/config.h"

#include <cstdint>

namespace ffgpu::work {

struct DepthTestPlace {
    bool early = false; // before texturing, and only there
    bool twice = false; // before texturing, and once more, and written, after it

    // Those that the first test leaves: as it was done; all, where the machine tests later; where
    // it tests twice, all but those that the second test would end.
    std::uint8_t after_early_test(const WorkQuad& quad) const {
        if (early) return quad.after_early_depth;
        const unsigned failed = twice ? quad.after_alpha & ~quad.after_depth : 0;
        return static_cast<std::uint8_t>(quad.covered & ~failed);
    }
    // Those that come to the first test of the machine.
    std::uint8_t tested(const WorkQuad& quad) const {
        if (early || twice) return quad.covered;
        const unsigned killed = quad.after_early_depth & ~quad.after_alpha;
        return static_cast<std::uint8_t>(quad.covered & ~killed);
    }
};

inline DepthTestPlace depth_test_place(const WorkDraw& draw, DepthTest wanted) {
    DepthTestPlace place;
    place.early = draw.early_depth && wanted != DepthTest::Late;
    if (wanted != DepthTest::EarlyWhereExact || draw.early_depth || !draw.state) return place;
    const Registers& state = *draw.state;
    place.twice = state.targets.depth.format != Format::None && state.depth.test_enable &&
                  !state.depth.bounds_enable && !state.stencil.enable;
    return place;
}

} // namespace ffgpu::work
