// DrawContext: a set of register values compiled for every stage. Draws with the same registers
// share one.

#pragma once

#include "model/fragment/fragment_pipe.h"
#include "model/packets/draw_state.h"
#include "model/raster/setup.h"
#include "model/raster/stipple.h"
#include "model/texture/texture_unit.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>

namespace ffgpu {

struct DrawContext {
    DrawState state; // Its number is that of the first draw.
    SetupContext setup;
    StipplePatterns stipple;
    FragmentPipe pipe;
    std::array<TextureUnit, TextureUnits> textures; // those of state.units

    const Registers& regs() const { return *state.registers; }
    bool samples(unsigned unit) const { return state.units >> unit & 1; }
};

std::shared_ptr<const DrawContext> compile_draw_context(std::shared_ptr<const Registers> registers,
                                                        std::uint32_t number,
                                                        std::span<std::byte> memory);

} // namespace ffgpu
