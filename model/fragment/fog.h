// Fog: the colour fades into the fog's with the fog coordinate (GL 1.5, 3.10).
//
// The factor f is binary32 up to a fixed-point value, and 8 bits wide from there on:
//
//     Linear   f = (end - c) * (1 / (end - start))
//     Exp      f = 2^-x, x = c * (density * log2 e)
//     Exp2     f = 2^-x, x = (c * density)^2 * log2 e
//
// f is clamped to [0, 1] and rounded to 0 .. 255. Coordinate and coefficients are 0 or between
// powers of two (in_fog_range). end = start: f is 1 before the end and 0 from there on.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

// The coefficients of a draw's fog, made once.
struct FogCurve {
    FogMode mode = FogMode::Off;
    float end = 1;
    float scale = 1; // Linear: 1 / (end - start); Exp: density * log2 e; Exp2: density
    PixelColor color{};
};

constexpr float Log2E = 1.44269504f;
constexpr float FogExponentLimit = 11.5f; // 255 * 2^-11.5 rounds to 0

FogCurve compile_fog(const Fog& fog);

// The specification.
std::uint8_t fog_factor(const FogCurve& curve, float coordinate);

// round((f C + (255 - f) Cf) / 255) for r g b; alpha stays.
PixelColor apply_fog(const FogCurve& curve, std::uint8_t factor, PixelColor color);

// Every lane of batch.color.
void apply_fog(const FogCurve& curve, FragmentBatch& batch);
void apply_fog_scalar(const FogCurve& curve, FragmentBatch& batch);

} // namespace ffgpu
