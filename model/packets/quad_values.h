// QuadValues: which of a quad's values a work stream tells, where somebody asks for them, and in
// which order: a list of words, cut up by the quad's masks and the draw's registers alone.
//
//   depths       of the samples that primitives cover, in units of the depth target
//   depth words  pixels of the depth target as they are afterwards, of the samples that came to its
//                tests (with stencil; a word before them says which) or that passed (without)
//   colour words the same of each colour target, of the samples that were written
//
// Samples are in the order of their bits: 4 lane + sample; of single-sampled targets, 4 lane.

#pragma once

#include "model/device/registers.h"
#include "model/packets/work_stream.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace ffgpu {

using SampleBits = std::uint16_t; // bit 4 lane + sample

// What of its draw's quads is told.
struct QuadValueKinds {
    bool depths = false;
    bool depth_words = false;
    bool tested_mask = false; // The depth words are those of a mask of their own.
    std::uint8_t colors = 0;  // one bit a colour target
    bool multisampled = false;

    static QuadValueKinds of(const Registers& registers) {
        const Surface& depth = registers.targets.depth;
        const bool stencil = registers.stencil.enable && depth.format == Format::Depth24Stencil8;
        QuadValueKinds kinds;
        kinds.multisampled = registers.targets.samples() > 1;
        if (depth.format != Format::None) {
            kinds.depths = registers.depth.test_enable;
            kinds.depth_words =
                stencil || (registers.depth.test_enable && registers.depth.write_enable);
            kinds.tested_mask = stencil;
        }
        for (unsigned i = 0; i < ColorTargets; ++i)
            if (registers.targets.color[i].format != Format::None &&
                registers.blend.write_mask != 0)
                kinds.colors = static_cast<std::uint8_t>(kinds.colors | 1u << i);
        return kinds;
    }
};

// The samples of the lanes in a quad's mask.
constexpr SampleBits lanes_to_samples(unsigned lanes) {
    return static_cast<SampleBits>((lanes & 1) | (lanes & 2) << 3 | (lanes & 4) << 6 |
                                   (lanes & 8) << 9);
}

inline SampleBits covered_samples(const WorkQuad& quad, bool multisampled) {
    return multisampled ? quad.samples_covered : lanes_to_samples(quad.covered);
}
inline SampleBits written_samples(const WorkQuad& quad, bool multisampled) {
    return multisampled ? quad.samples_written : lanes_to_samples(quad.after_depth);
}

// Calls each(lane, sample) for each bit, the lowest first.
template <class Each>
void for_each_sample(SampleBits bits, Each&& each) {
    for (unsigned rest = bits; rest != 0; rest &= rest - 1) {
        const auto bit = static_cast<unsigned>(std::countr_zero(rest));
        each(bit / 4, bit % 4);
    }
}

// A mask and the values of its samples.
struct SampleWords {
    SampleBits samples = 0;
    std::span<const std::uint32_t> words;
};

struct QuadValues {
    SampleWords depths, depth_words;
    std::array<SampleWords, ColorTargets> colors;

    // Cuts up `words`. False: they are too few or too many.
    static bool parse(const QuadValueKinds& kinds,
                      SampleBits covered,
                      SampleBits written,
                      std::span<const std::uint32_t> words,
                      QuadValues& out) {
        bool fits = true;
        const auto take = [&](SampleBits samples) {
            const auto count = static_cast<std::size_t>(std::popcount(samples));
            fits = fits && count <= words.size();
            const SampleWords taken{samples, words.first(fits ? count : 0)};
            words = words.subspan(taken.words.size());
            return taken;
        };
        out = {};
        if (kinds.depths) out.depths = take(covered);
        if (kinds.depth_words) {
            SampleBits stored = written;
            if (kinds.tested_mask) {
                if (words.empty()) return false;
                stored = static_cast<SampleBits>(words[0]);
                words = words.subspan(1);
            }
            out.depth_words = take(stored);
        }
        for (unsigned i = 0; i < ColorTargets; ++i)
            if (kinds.colors >> i & 1) out.colors[i] = take(written);
        return fits && words.empty();
    }
};

} // namespace ffgpu
