// ControlPanel: what the user forces on programs whatever they ask for, as the control panels of
// drivers do. Programs do not see it.

#pragma once

#include "driver/ffgpu_texture_filter.h"
#include "driver/gl_types.h"
#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::gl {

// The filter of each texture whose minification filter is not GL_NEAREST.
enum class ForcedFilter : std::uint8_t {
    AsAsked,
    Standard,
    Bicubic,
    RipMap,
    SummedArea,
    Elliptic,
    Feline,
};
inline constexpr std::array<std::string_view, 7> ForcedFilterNames{
    "as_asked", "standard", "bicubic", "rip_map", "summed_area", "elliptic", "feline"};

// A value of GL_TEXTURE_FILTER_FFGPU. Not of AsAsked.
constexpr GLenum filter_token(ForcedFilter filter) {
    return GL_STANDARD_FILTER_FFGPU + static_cast<GLenum>(filter) -
           static_cast<GLenum>(ForcedFilter::Standard);
}
static_assert(filter_token(ForcedFilter::Feline) == GL_FELINE_FILTER_FFGPU);

constexpr std::uint32_t MaxSupersampling = MaxPictures;

struct ControlPanel {
    ForcedFilter texture_filter = ForcedFilter::AsAsked;
    // Pictures of each window that are drawn, each shifted by another part of a pixel, and averaged
    // where somebody looks: a power of two up to MaxSupersampling.
    std::uint32_t supersampling = 1;

    bool operator==(const ControlPanel&) const = default;
};

} // namespace ffgpu::gl
