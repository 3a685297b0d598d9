// DrawState: the registers of one draw, and what the stages derived from them once.

#pragma once

#include "model/device/registers.h"
#include "model/packets/interpolants.h"

#include <cstdint>
#include <memory>

namespace ffgpu {

struct DrawState {
    std::shared_ptr<const Registers> registers;
    std::uint32_t number = 0; // PrimitiveKey::draw
    InterpolantLayout layout;
    std::uint8_t units =
        0; // one bit a texture unit that is sampled: image present and used by a combiner
    bool early_depth = false; // The depth test may run before texturing: same result.
    bool needs_depth = false; // Depth is tested, written or compared.
    bool antialias = false;   // Coverage of smooth primitives scales alpha.
    std::uint8_t samples = 1; // of a pixel of the targets
    bool multisample = false; // Primitives cover samples. False: pixels, and all their samples.

    const Registers& regs() const { return *registers; }
};

// Whether any fragment's colour can matter: it is written or tested. Else nobody makes one, and
// what batches have in its place does not count.
bool uses_color(const Registers& registers);

// Derives everything from the registers. Pure.
DrawState compile_draw_state(std::shared_ptr<const Registers> registers, std::uint32_t number);

} // namespace ffgpu
