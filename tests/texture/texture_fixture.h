// What the tests of the texture unit share: a texture in memory, random registers, a plain way to
// sample one fragment.

#pragma once

#include "model/texture/texture_unit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace ffgpu::test {

using Random = std::mt19937;

// Raw draws only: distributions differ between standard libraries.
inline std::uint32_t below(Random& random, std::uint32_t limit) {
    return static_cast<std::uint32_t>(std::uint64_t{random()} * limit >> 32);
}

// Device memory that holds one texture, with the 64 bytes of slack behind it filled with a pattern
// that would show in a result.
struct TextureMemory {
    TextureImage image;
    std::vector<std::byte> bytes;

    explicit TextureMemory(const TextureShape& shape, DeviceAddress address = 64)
        : image{shape, address}
        , bytes(address + texture_bytes(shape) + 64, std::byte{0xa5}) {}

    std::span<const std::byte> span() const { return std::span(bytes).first(bytes.size() - 64); }

    // First byte of texel (x, y) of a layer, as stored (a border counts).
    std::byte* at(unsigned level, unsigned layer, unsigned x, unsigned y) {
        const LevelLayout layout = level_layout(image.shape, level);
        const std::size_t in_layer =
            std::size_t{y} * layout.row_stride + x * format_info(image.shape.format).block_bytes;
        return bytes.data() + image.address + layout.offset +
               std::size_t{layer} * layout.layer_stride + in_layer;
    }
    void put_rgba8(unsigned level, unsigned layer, unsigned x, unsigned y, std::uint32_t rgba) {
        for (unsigned i = 0; i < 4; ++i)
            at(level, layer, x, y)[i] = static_cast<std::byte>(rgba >> (8 * i));
    }
    void fill_random(Random& random) {
        for (std::size_t i = 0; i + 64 < bytes.size(); ++i)
            bytes[i] = static_cast<std::byte>(random());
    }
    TextureUnit compile(const Sampler& sampler) const {
        return compile_texture_unit(image, sampler, span());
    }
};

inline Sampler nearest_sampler(Wrap wrap = Wrap::Repeat) {
    Sampler sampler;
    sampler.wrap = {wrap, wrap, wrap};
    sampler.magnify_linear = sampler.minify_linear = false;
    sampler.mip_filter = MipFilter::None;
    return sampler;
}

inline Sampler linear_sampler(Wrap wrap = Wrap::Repeat) {
    Sampler sampler = nearest_sampler(wrap);
    sampler.magnify_linear = sampler.minify_linear = true;
    return sampler;
}

inline FragmentMask all_live(unsigned quad_count) {
    FragmentMask mask;
    for (unsigned lane = 0; lane < 4 * quad_count; ++lane)
        mask.set(lane);
    return mask;
}

inline SampleQuads all_quads(unsigned quad_count) {
    return {quad_count, all_live(quad_count), all_live(quad_count)};
}

struct Coordinates {
    float s = 0, t = 0, r = 0;
};

inline std::unique_ptr<TexCoordPlanes>
make_planes(unsigned quad_count, const std::function<Coordinates(unsigned lane)>& coordinates) {
    auto planes = std::make_unique<TexCoordPlanes>();
    for (unsigned lane = 0; lane < 4 * quad_count; ++lane) {
        const Coordinates at = coordinates(lane);
        planes->s[lane] = at.s;
        planes->t[lane] = at.t;
        planes->r[lane] = at.r;
    }
    return planes;
}

using Color = std::array<unsigned, 4>;

inline Color color_of(const ColorPlanes& planes, unsigned lane) {
    return {planes.r[lane], planes.g[lane], planes.b[lane], planes.a[lane]};
}

// The colour at one point of a texture whose coordinates do not change: level 0, magnified.
inline Color sample_point(const TextureUnit& unit, const Coordinates& at) {
    const auto planes = make_planes(1, [&](unsigned) { return at; });
    ColorPlanes out;
    sample(unit, *planes, all_quads(1), out, nullptr);
    return color_of(out, 0);
}

} // namespace ffgpu::test
