#include "driver/window_system/binding/formats.h"

namespace ffgpu::gl {
namespace {

struct DepthStencil {
    std::uint8_t depth, stencil;
};
constexpr DepthStencil DepthStencils[] = {{24, 8}, {24, 0}, {16, 0}, {0, 0}};

} // namespace

std::vector<PixelFormat> offered_formats(bool with_accumulation) {
    std::vector<PixelFormat> formats;
    for (const bool accumulation : {false, true}) {
        if (accumulation && !with_accumulation) continue;
        for (const bool alpha : {true, false})
            for (const DepthStencil bits : DepthStencils)
                for (const bool double_buffer : {true, false})
                    formats.push_back({.double_buffer = double_buffer,
                                       .alpha = alpha,
                                       .depth_bits = bits.depth,
                                       .stencil_bits = bits.stencil,
                                       .accumulation = accumulation});
    }
    return formats;
}

} // namespace ffgpu::gl
