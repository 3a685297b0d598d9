// DrawContext: a set of register values compiled for every stage. Draws with the same registers
// share one; draws that differ in geometry's registers alone share the part of it that makes
// pixels, and so can share batches.

#pragma once

#include "model/base/cache_lines.h"
#include "model/fragment/fragment_pipe.h"
#include "model/packets/draw_state.h"
#include "model/raster/setup.h"
#include "model/raster/stipple.h"
#include "model/texture/texture_unit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu {

// From the rasterizer's batches on. Threads that draw read it while another counts who refers to
// it.
struct alignas(CacheLinePair) PixelContext {
    InterpolantLayout layout;
    std::uint8_t units = 0; // DrawState::units
    bool needs_depth = false;
    bool antialias = false;
    bool multisample = false; // DrawState::multisample
    bool count_samples = false;
    bool draws_colors = true; // false: nobody wants them, and they decide on no fragment
    StipplePatterns stipple;
    FragmentPipe pipe;
    std::array<TextureUnit, TextureUnits> textures; // those of `units`

    bool samples(unsigned unit) const { return units >> unit & 1; }
};

struct DrawContext {
    DrawState state; // Its number is that of the first draw.
    SetupContext setup;
    std::shared_ptr<const PixelContext> pixels;

    const Registers& regs() const { return *state.registers; }
};

// Compiles pixel contexts, and keeps the last ones: applications go back to values of before.
class PixelContexts {
public:
    // `colors`: false, if nobody wants those that decide on no fragment.
    PixelContexts(std::span<std::byte> memory, const FragmentStages& stages, bool colors = true)
        : memory_(memory)
        , stages_(stages)
        , colors_(colors) {}

    std::shared_ptr<const PixelContext> of(const DrawState& state);

private:
    struct Kept {
        std::uint64_t fingerprint = 0; // of the registers
        std::shared_ptr<const PixelContext> pixels;
    };
    static constexpr std::size_t Most = 64; // Some 10 KiB each.

    std::span<std::byte> memory_;
    const FragmentStages& stages_;
    const bool colors_;
    std::vector<Kept> kept_;
    std::size_t next_ = 0; // the place that is taken next: the oldest one's
};

// `earlier`, if not null, may lend its pixel context: only geometry's registers have changed since.
std::shared_ptr<const DrawContext> compile_draw_context(std::shared_ptr<const Registers> registers,
                                                        std::uint32_t number,
                                                        PixelContexts& pixels,
                                                        const DrawContext* earlier);

} // namespace ffgpu
