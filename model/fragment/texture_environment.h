// The texture environment of one unit: a combiner for colour and one for alpha (GL 1.5, 3.8.13).
//
// Arithmetic: arguments are n / 255. The operation and the scale (1, 2 or 4) are carried out
// exactly, the result is clamped to [0, 1] and rounded once, to nearest, ties up.
// docs/arithmetic/fragment.md has the formulas.

#pragma once

#include "model/device/registers/texture.h"
#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <array>
#include <span>
#include <vector>

namespace ffgpu {

struct CombineInputs {
    std::array<PixelColor, TextureUnits> texture; // A unit that is not sampled is UnsampledTexture.
    PixelColor primary;
    PixelColor previous; // the result of the unit before; of the first one the primary colour
};

constexpr PixelColor UnsampledTexture{0, 0, 0, 255};

// The specification of one enabled unit for one fragment. Sources and operations beyond their
// lists read as Zero and act as Replace; a scale beyond 4 is 4.
PixelColor combine(const Combiner& combiner, const CombineInputs& inputs);

// --- On batches -------------------------------------------------------------------------------

// One argument of one channel: a plane of the batch or a constant, perhaps complemented.
struct PlaneArgument {
    std::uint32_t offset = 0;     // of the plane, in bytes from the batch; unused for a constant
    std::uint32_t step = 0;       // 1 for a plane, 0 for a constant
    std::uint16_t complement = 0; // 255: one minus the argument
    std::uint8_t primary = 0;     // of the primary colour's plane as it is: its channel's bit
    alignas(64) std::array<std::uint16_t, 32> constant{}; // the widest vector of it
};

// One channel of one unit: result plane = op(arguments).
struct PlaneProgram {
    CombineOp op = CombineOp::Replace;
    std::uint8_t scale_shift = 0;
    std::array<PlaneArgument, 4> arguments;
};

struct UnitProgram {
    std::uint8_t unit = 0;
    Combiner combiner;        // what the rest was compiled from
    bool dot_product = false; // of rgb, with the arguments of channels 0 to 2
    bool alpha_from_dot = false;
    std::array<PlaneProgram, 4> channels;
};

// The enabled units in order. The first takes the primary colour as the previous one.
struct EnvironmentProgram {
    std::uint8_t sampled_units = 0; // a bit each; the others read as UnsampledTexture
    std::vector<UnitProgram> units; // Large: most draws have none, or one.
};

EnvironmentProgram compile_environments(std::span<const Combiner, TextureUnits> combiners,
                                        std::uint8_t sampled_units);

// Every lane: the i-th enabled unit, from primary colour, samples and (but for the first)
// batch.color to batch.color.
void run_environment(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch);
void run_environment_scalar(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch);

} // namespace ffgpu
