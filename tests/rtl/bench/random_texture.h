// Textures' registers with anything in them that an image can have, and the model's unit for them.

#pragma once

#include "model/base/check.h"
#include "model/texture/texture_unit.h"
#include "rtl/bundles/state.h"
#include "tests/rtl/bench/random.h"

#include <cmath>
#include <memory>

namespace ffgpu::rtl {

// Sizes of all kinds, small ones often; any wrap and mip mode.
inline TextureWords random_texture(Random& random) {
    const auto kind = static_cast<TextureKind>(1 + random.below(5));
    const unsigned most = kind == TextureKind::ThreeD ? 512 : 4096;
    const auto size = [&] {
        const std::uint32_t power = 1u << random.below(kind == TextureKind::ThreeD ? 10 : 13);
        return static_cast<std::uint16_t>(random.one_in(3) ? 1 + random.below(most) : power);
    };
    TextureWords words;
    words.image = {.shape = {.kind = kind, .format = Format::Luminance8}, .srgb = random.one_in(2)};
    words.image.shape.width = size();
    words.image.shape.height = size();
    words.image.shape.depth = kind == TextureKind::ThreeD ? size() : std::uint16_t{1};
    words.image.shape.levels = static_cast<std::uint8_t>(1 + random.below(15));
    words.image.shape.border = random.one_in(4);
    const auto lod = [&] { return static_cast<std::int16_t>(random.below(32 * 256) - 16 * 256); };
    words.sampler = {.wrap = {random.any<Wrap>(8), random.any<Wrap>(8), random.any<Wrap>(8)},
                     .magnify_linear = random.one_in(2),
                     .minify_linear = !random.one_in(3),
                     .mip_filter = random.any<MipFilter>(random.one_in(8) ? 4 : 3),
                     .max_level = static_cast<std::uint8_t>(random.below(16)),
                     .bias = random.one_in(2) ? std::int16_t{0} : lod(),
                     .max_anisotropy =
                         static_cast<std::uint8_t>(random.one_in(2) ? random.below(32) : 16)};
    if (random.one_in(4)) words.sampler.min_lod = lod();
    if (random.one_in(4)) words.sampler.max_lod = lod();
    return words;
}

// Room for any of these images; nobody reads it.
inline TextureUnit model_unit(const TextureWords& words) {
    constexpr std::size_t Bytes = std::size_t{1} << 29;
    static const std::unique_ptr<std::byte[]> memory(new std::byte[Bytes]);
    const TextureUnit unit =
        compile_texture_unit(words.image, words.sampler, {memory.get(), Bytes});
    check(unit.valid, "a random texture without an image");
    return unit;
}

// 0 or any sign and mantissa with an exponent of this range.
inline float random_number(Random& random, int least, int most) {
    if (random.one_in(40)) return random.one_in(2) ? 0.0f : -0.0f;
    const auto exponent = static_cast<std::uint32_t>(127 + least) +
                          random.below(static_cast<std::uint32_t>(most - least + 1));
    return std::bit_cast<float>((random.word() & 0x807fffff) | exponent << 23);
}

} // namespace ffgpu::rtl
