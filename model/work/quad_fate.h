// The common fates of a quad's fragments and samples, which a work file tells in a byte.

#pragma once

#include "model/packets/work_stream.h"

#include <cstdint>

namespace ffgpu::work {

enum class QuadFate : std::uint8_t {
    AllWritten,     // Every mask equals the covered one.
    DeadEarly,      // Nothing is left after the early depth test.
    SurvivorsWrite, // What the early depth test left is written.
    Other,
    Count
};

enum class SampleFate : std::uint8_t {
    None,  // The targets have one sample a pixel.
    Whole, // All samples of the covered fragments; of the written ones, all are written.
    Other,
    Count
};

inline void set_masks(WorkQuad& quad, std::uint8_t early, std::uint8_t written) {
    quad.after_early_depth = early;
    quad.after_coverage = quad.after_alpha = quad.after_stencil = quad.after_depth = written;
}

// All samples of the lanes.
constexpr std::uint16_t whole_samples(unsigned lanes) {
    unsigned bits = 0;
    for (unsigned lane = 0; lane < 4; ++lane)
        if ((lanes >> lane & 1) != 0) bits |= 0xfu << 4 * lane;
    return static_cast<std::uint16_t>(bits);
}

inline bool masks_are(const WorkQuad& quad, std::uint8_t early, std::uint8_t written) {
    return quad.after_early_depth == early && quad.after_coverage == written &&
           quad.after_alpha == written && quad.after_stencil == written &&
           quad.after_depth == written;
}

inline QuadFate fate_of(const WorkQuad& quad) {
    if (masks_are(quad, quad.covered, quad.covered)) return QuadFate::AllWritten;
    if (masks_are(quad, 0, 0)) return QuadFate::DeadEarly;
    if (masks_are(quad, quad.after_early_depth, quad.after_early_depth))
        return QuadFate::SurvivorsWrite;
    return QuadFate::Other;
}

inline SampleFate sample_fate_of(const WorkQuad& quad) {
    if (quad.samples_covered == 0 && quad.samples_written == 0) return SampleFate::None;
    if (quad.samples_covered == whole_samples(quad.covered) &&
        quad.samples_written == whole_samples(quad.after_depth))
        return SampleFate::Whole;
    return SampleFate::Other;
}

} // namespace ffgpu::work
