// rtl/texel_decode.sv against the decoders that read_texel() calls.

#include "Vtexel_decode.h"
#include "model/arith/fxt1.h"
#include "model/texture/depth_compare.h"
#include "model/texture/s3tc.h"
#include "model/texture/texel_decode.h"
#include "rtl/bundles/quad.h"
#include "rtl/bundles/texel.h"
#include "tests/rtl/bench/random_quad.h"
#include "tests/rtl/bench/unit_bench.h"

#include <cstring>

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct TexelDecode {
    static constexpr const char* Name = "texel_decode";
    static constexpr std::string_view Latency = "TexelDecodeLatency";
    static constexpr std::uint64_t ShortItems = 400000, LongItems = 10000000;
    static constexpr unsigned FormatCount = 18; // what textures may have, and none

    using Dut = Vtexel_decode;
    using State = NoState;
    using Input = TexelBlock;
    using Output = Texel;

    static void set_tag(TexelBlock& texel, unsigned tag) { texel.tag = tag != 0; }

    static State random_state(Random&) { return {}; }
    static TexelBlock random_input(Random& random, const State&) {
        TexelBlock texel{.place = static_cast<std::uint16_t>(random.below(1024)),
                         .is_border = random.one_in(8),
                         .format = static_cast<Format>(1 + random.below(FormatCount - 1)),
                         .srgb = random.one_in(3),
                         .compare_enable = random.one_in(2),
                         .relation = random.any<Compare>(8),
                         .depth_mode = random.any<DepthMode>(3),
                         .reference = random.word() >> 8,
                         .x = static_cast<std::uint8_t>(random.below(8)),
                         .y = static_cast<std::uint8_t>(random.below(4))};
        for (std::uint32_t& word : texel.block)
            word = random.word();
        // End points alike and a step apart, and references near the depth.
        if (random.one_in(4)) texel.block[0] = texel.block[2] = random_color(random);
        if (random.one_in(8)) {
            const std::uint32_t end = random.word() & 0xffff;
            texel.block[0] = texel.block[2] = end << 16 | ((end + random.below(3) - 1) & 0xffff);
        }
        if (random.one_in(2)) texel.reference = depth_of(texel) + random.below(3) - 1;
        if (random.one_in(4)) texel.reference = depth_of(texel) ^ 1u << random.below(24);
        texel.reference &= 0xffffff;
        return texel;
    }

    static std::uint32_t depth_of(const TexelBlock& texel) {
        if (texel.is_border || !format_info(texel.format).is_depth)
            return texel.block[0] & 0xffffff;
        return decode_depth_texel(texel.format, bytes(texel));
    }
    static const std::byte* bytes(const TexelBlock& texel) {
        return reinterpret_cast<const std::byte*>(texel.block.data());
    }

    static void declare(Bins& bins) {
        bins.declare("format", FormatCount);
        bins.declare("texel of a block by format", 6 * 32);
        bins.declare("S3TC order and code", 2 * 4);
        bins.declare("DXT5 order and code", 2 * 8);
        bins.declare("FXT1 coding", 8);
        bins.declare("comparison: below, equal, above", 8 * 3);
        bins.declare("depth mode", 3);
        bins.declare("sRGB by border", 4);
    }
    static void cover(Bins& bins, const State&, const TexelBlock& texel) {
        const auto number = [](auto value) { return static_cast<std::size_t>(value); };
        bins.hit("format", number(texel.format));
        bins.hit("format", 0); // None is declared to keep the numbers.
        if (format_info(texel.format).is_depth) {
            bins.hit("depth mode", number(texel.depth_mode));
            const std::uint32_t depth = depth_of(texel);
            bins.hit("comparison: below, equal, above",
                     3 * number(texel.relation) + (texel.reference >= depth) +
                         (texel.reference > depth ? 1u : 0u));
            return;
        }
        bins.hit("sRGB by border", 2u * texel.srgb + texel.is_border);
        if (format_info(texel.format).block_width > 1 && !texel.is_border) cover_block(bins, texel);
    }
    static void cover_block(Bins& bins, const TexelBlock& texel) {
        const std::size_t kind =
            static_cast<std::size_t>(texel.format) - static_cast<std::size_t>(Format::Dxt1Rgb);
        const unsigned number = 4u * texel.y + texel.x % 4u;
        bins.hit("texel of a block by format", 32 * kind + 8u * texel.y + texel.x);
        if (texel.format >= Format::Fxt1Rgb) return bins.hit("FXT1 coding", texel.block[3] >> 29);
        const bool late = texel.format >= Format::Dxt3;
        const std::uint32_t ends = texel.block[late ? 2 : 0];
        bins.hit("S3TC order and code",
                 ((ends & 0xffff) > ends >> 16 ? 4u : 0u) +
                     (texel.block[late ? 3 : 1] >> 2 * number & 3));
        const std::uint64_t alphas = texel.block[0] | std::uint64_t{texel.block[1]} << 32;
        if (texel.format == Format::Dxt5)
            bins.hit("DXT5 order and code",
                     ((alphas & 255) > (alphas >> 8 & 255) ? 8u : 0u) +
                         (alphas >> (16 + 3 * number) & 7));
    }

    static Rgba color_of(const TexelBlock& texel) {
        if (texel.is_border) return unpack_rgba8(texel.block[0]);
        switch (format_info(texel.format).block_width) {
        case 8:
            return decode_fxt1(bytes(texel), texel.x, texel.y, texel.format == Format::Fxt1Rgba);
        case 4:
            return decode_s3tc(texel.format, bytes(texel), texel.x % 4u, texel.y);
        default:
            return decode_color_texel(texel.format, bytes(texel));
        }
    }
    static void expect(const State&, const TexelBlock& texel, std::vector<Texel>& outputs) {
        Rgba color{};
        if (format_info(texel.format).is_depth) {
            const Sampler sampler{.compare_enable = texel.compare_enable,
                                  .compare = texel.relation,
                                  .depth_mode = texel.depth_mode};
            color = depth_color(sampler, texel.reference, depth_of(texel));
        } else {
            color = color_of(texel);
            if (texel.srgb && !texel.is_border) color = linear_from_srgb(color);
        }
        outputs.push_back({texel.tag, texel.place, pack_rgba8(color)});
    }
};
using Unit = TexelDecode;

// Formats of 8 and 16 bits: every stored word, read as it is and as sRGB codes.
TEST_CASE("plain formats of up to 16 bits equal the model's on every texel") {
    TexelDecode unit;
    UnitBench<TexelDecode> bench(unit);
    constexpr std::array Narrow{Format::Luminance8,
                                Format::Alpha8,
                                Format::Intensity8,
                                Format::LuminanceAlpha8,
                                Format::Rgb565,
                                Format::Rgba4,
                                Format::Rgb5a1,
                                Format::Depth16};
    const auto state = [](unsigned) { return NoState{}; };
    const auto input = [&](unsigned n, unsigned i) {
        return TexelBlock{.format = Narrow[n / 2], .srgb = n % 2 != 0, .block = {i}};
    };
    bench.run(counted_source<TexelDecode>(16, 1 << 16, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == 16 << 16);
}

// S3TC: every pair of a channel's end points, in either order, with every code.
TEST_CASE("S3TC steps equal the model's between every two levels of a channel") {
    TexelDecode unit;
    UnitBench<TexelDecode> bench(unit);
    // Codes of DXT5's alphas stand in two rows.
    struct Row {
        Format format;
        std::uint8_t y;
    };
    constexpr std::array Rows{Row{Format::Dxt1Rgb, 0},
                              Row{Format::Dxt1Rgba, 0},
                              Row{Format::Dxt3, 0},
                              Row{Format::Dxt5, 0},
                              Row{Format::Dxt5, 1}};
    std::array<unsigned, 2 * 8> alphas{}; // by their order and code
    const auto state = [](unsigned) { return NoState{}; };
    // Twelve bits of two greens, with reds and blues alike; or two alphas of DXT5.
    const auto input = [&](unsigned n, unsigned i) {
        const std::uint32_t ends = (i & 63) << 5 | (i >> 6 & 31) << 11 | (i >> 6 & 31) |
                                   (i >> 6 & 63) << 21 | (i & 31) << 27 | (i & 31) << 16;
        const std::uint32_t codes = 0xe4e4e4e4;
        const Row row = Rows[n / 4];
        TexelBlock texel{.format = row.format, .x = static_cast<std::uint8_t>(n % 4), .y = row.y};
        const std::uint64_t alpha_codes = 0xfac688; // 0 to 7, behind the two alphas
        const std::uint64_t alpha = i | alpha_codes << 16;
        if (row.format == Format::Dxt5)
            ++alphas[((i & 255) > i >> 8 ? 8u : 0u) +
                     (alpha >> (16 + 3 * (4u * texel.y + texel.x)) & 7)];
        const auto low = static_cast<std::uint32_t>(alpha);
        const auto high = static_cast<std::uint32_t>(alpha >> 32);
        texel.block = n / 4 < 2 ? std::array<std::uint32_t, 4>{ends, codes, 0, 0}
                                : std::array<std::uint32_t, 4>{low, high, ends, codes};
        return texel;
    };
    constexpr auto Draws = static_cast<unsigned>(4 * Rows.size());
    bench.run(counted_source<TexelDecode>(Draws, 1 << 16, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == Draws << 16);
    for (unsigned i = 0; i < alphas.size(); ++i)
        CHECK(alphas[i] == (i < 8 ? 256 * 257 / 2 : 256 * 255 / 2));
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
