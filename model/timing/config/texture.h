// The configuration of the texture units.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class UnitShare : std::uint8_t { Textures, Samples };
inline constexpr std::array<std::string_view, 2> UnitShareNames{"textures", "samples"};

struct TextureConfig {
    static constexpr std::string_view Name = "texture";
    std::uint32_t units = 1;
    UnitShare share = UnitShare::Textures;
    std::uint32_t miss_cycles = 0;

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
    }
};

} // namespace ffgpu::timing
