// Footprint: the texels that a fragment's texture colour is made of, each with its share.

#pragma once

#include "tools/explain/pixel_history.h"

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace ffgpu::tools {

struct TexelName {
    unsigned level = 0, layer = 0, y = 0, x = 0; // as in TexelAccess

    // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14.
    auto operator<=>(const TexelName&) const = default;
};

// Shares add up to 1 less what the border colour has: of a fragment's probes, levels and axes.
std::map<TexelName, double> texel_shares(const TextureNote& texture);

} // namespace ffgpu::tools
