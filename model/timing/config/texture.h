// The configuration of the texture units.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class UnitShare : std::uint8_t { Textures, Samples };
inline constexpr std::array<std::string_view, 2> UnitShareNames{"textures", "samples"};

enum class TexelRate : std::uint8_t { Samples, Texels };
inline constexpr std::array<std::string_view, 2> TexelRateNames{"samples", "texels"};

struct TextureConfig {
    static constexpr std::string_view Name = "texture";
    std::uint32_t units = 1;
    UnitShare share = UnitShare::Textures;
    std::uint32_t miss_cycles = 0;
    TexelRate rate = TexelRate::Samples;
    std::uint32_t request_queue = 8;
    std::uint32_t sample_queue = 8;
    std::uint32_t texel_queue = 32;
    std::uint32_t latency = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("units",
              self.units,
              {.unit = "texture units",
               .minimum = 1,
               .maximum = 8,
               .meaning = "of each fragment pipe; each has look-ups and filters of its own and "
                          "works on the same quad as the others"});
        field("share",
              self.share,
              {.meaning = "what of a quad a unit filters: textures: every units-th of the draw's "
                          "textures; samples: any bilinear sample, so that one trilinear texture "
                          "keeps two units busy",
               .choices = UnitShareNames});
        field("miss_cycles",
              self.miss_cycles,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 64,
               .meaning = "that a miss takes a pipe's tags beside its look-up; the paper on "
                          "prefetching (Igehy 1998) has 1"});
        field("rate",
              self.rate,
              {.meaning =
                   "samples: tags compare lines, filters take bilinear samples; texels: tags, "
                   "data and filter take a quad's texels one after the other, a cycle each",
               .choices = TexelRateNames});
        field("request_queue",
              self.request_queue,
              {.unit = "requests",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "rate texels: of quads, one a texture, before a sequencer, which takes a "
                          "cycle for each and one for each of its samples"});
        field("sample_queue",
              self.sample_queue,
              {.unit = "samples",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "rate texels: between the sequencer and the tags"});
        field("texel_queue",
              self.texel_queue,
              {.unit = "texels",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "rate texels: between tags and data: hides misses"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 1024,
               .meaning = "rate texels: of a quad with samples, beside its texels' cycles"});
    }
};

} // namespace ffgpu::timing
