// What happens to pixels on their way (glPixelTransfer, glPixelMap, glPixelZoom; GL 1.5, 3.6.3).

#pragma once

#include "driver/gl_types.h"

#include <array>
#include <vector>

namespace ffgpu::gl {

// In the order of the tokens GL_PIXEL_MAP_I_TO_I .. GL_PIXEL_MAP_A_TO_A.
enum class PixelMapName { IToI, SToS, IToR, IToG, IToB, IToA, RToR, GToG, BToB, AToA, Count };

struct PixelState {
    bool map_color = false;
    bool map_stencil = false;
    GLint index_shift = 0;
    GLint index_offset = 0;
    std::array<float, 4> scale{1, 1, 1, 1}; // r g b a
    std::array<float, 4> bias{0, 0, 0, 0};
    float depth_scale = 1;
    float depth_bias = 0;
    float zoom_x = 1;
    float zoom_y = 1;

    // Indices in I_TO_I and S_TO_S as they were given, colours in [0, 1]. Never empty.
    std::array<std::vector<float>, static_cast<std::size_t>(PixelMapName::Count)> maps = [] {
        std::array<std::vector<float>, static_cast<std::size_t>(PixelMapName::Count)> initial;
        for (auto& map : initial)
            map = {0.0f};
        return initial;
    }();

    const std::vector<float>& map(PixelMapName name) const {
        return maps[static_cast<std::size_t>(name)];
    }
};

} // namespace ffgpu::gl
