#include "driver/window_system/binding/formats.h"

#include "driver/window_system/process_gpu.h"
#include "model/device/layout/limits.h"

#include <cstdlib>
#include <string_view>

namespace ffgpu::gl {
namespace {

struct DepthStencil {
    std::uint8_t depth, stencil;
};
constexpr DepthStencil DepthStencils[] = {{24, 8}, {24, 0}, {16, 0}, {0, 0}};

// FFGPU_SAMPLES=4: every window is multisampled, whatever the program asks for.
bool forces_samples() {
    const char* const text = std::getenv("FFGPU_SAMPLES");
    return text && std::string_view(text) == "4";
}
static_assert(MaxSamples == 4);

void add_formats(std::vector<PixelFormat>& formats, bool accumulation, unsigned samples) {
    const std::uint32_t pictures = samples == 1 ? ProcessGpu::control_panel().supersampling : 1;
    for (const bool alpha : {true, false})
        for (const DepthStencil bits : DepthStencils)
            for (const bool double_buffer : {true, false})
                formats.push_back({.double_buffer = double_buffer,
                                   .alpha = alpha,
                                   .depth_bits = bits.depth,
                                   .stencil_bits = bits.stencil,
                                   .accumulation = accumulation,
                                   .samples = static_cast<std::uint8_t>(samples),
                                   .supersampling = static_cast<std::uint8_t>(pictures)});
}

} // namespace

std::vector<PixelFormat> offered_formats(bool with_accumulation) {
    std::vector<PixelFormat> formats;
    for (const unsigned samples : {1u, MaxSamples}) {
        if (samples == 1 && forces_samples()) continue;
        add_formats(formats, false, samples);
        if (with_accumulation) add_formats(formats, true, samples);
    }
    return formats;
}

SwapMode swap_mode() {
    const char* const text = std::getenv("FFGPU_SWAP");
    return text && std::string_view(text) == "exchange" ? SwapMode::Exchange : SwapMode::Copy;
}

} // namespace ffgpu::gl
