// The common fates of a quad's fragments and samples, which a work file tells in a byte.

#pragma once

#include "model/packets/work_stream.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

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

// The masks as the lowest bytes of one word: they are compared at once.
inline QuadFate fate_of(const WorkQuad& quad) {
    constexpr std::uint64_t Each = 0x010101010101, All = 0xffffffffffff;
    static_assert(offsetof(WorkQuad, after_depth) == offsetof(WorkQuad, covered) + 5 &&
                  sizeof(WorkQuad) >= offsetof(WorkQuad, covered) + sizeof(std::uint64_t));
    std::uint64_t masks;
    std::memcpy(&masks,
                reinterpret_cast<const std::byte*>(&quad) + offsetof(WorkQuad, covered),
                sizeof masks);
    masks &= All;
    if (masks == quad.covered * Each) return QuadFate::AllWritten;
    if (masks >> 8 == 0) return QuadFate::DeadEarly;
    if (masks >> 8 == (quad.after_early_depth * Each & All) >> 8) return QuadFate::SurvivorsWrite;
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
