// Codes of blocks: what is decoded is what was encoded, for a decoder that shares no code, too; and
// the sizes that the format's description gives.

#include "model/work/block_code.h"

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

using Words = std::vector<std::uint32_t>;

// --- A decoder written from docs/units/depth_hierarchy.md alone ---------------------------------

class Bits {
public:
    explicit Bits(const std::vector<std::uint8_t>& bytes) {
        for (const std::uint8_t byte : bytes)
            for (int i = 0; i < 8; ++i)
                bits_.push_back((byte >> i) % 2 == 1);
    }
    std::int64_t take(unsigned n) {
        std::int64_t value = 0;
        for (unsigned i = 0; i < n; ++i)
            value += std::int64_t{bits_.at(at_++)} << i;
        return value;
    }
    std::int64_t take_signed(unsigned n) {
        const std::int64_t value = take(n);
        return n > 0 && value >= (std::int64_t{1} << n) / 2 ? value - (std::int64_t{1} << n)
                                                            : value;
    }
    std::size_t taken() const { return at_; }

private:
    std::vector<bool> bits_;
    std::size_t at_ = 0;
};

// Through (0, 0), (1, 0), (0, 1) in units of the runs, from the corner given by (x0, y0).
std::int64_t on_plane(const std::vector<std::int64_t>& z, double along_x, double along_y) {
    const auto term = [](std::int64_t rise, double along) {
        return static_cast<std::int64_t>(std::floor(static_cast<double>(rise) * along + 0.5));
    };
    return z[0] + term(z[1] - z[0], along_x) + term(z[2] - z[0], along_y);
}

std::vector<std::int64_t> reference_depths(Bits& in, unsigned w, unsigned h, unsigned bits) {
    const auto points = [&] {
        std::vector<std::int64_t> z(3, in.take(bits));
        if (w > 1) z[1] = in.take(bits);
        if (h > 1) z[2] = in.take(bits);
        return z;
    };
    std::vector<std::int64_t> depths(w * h);
    const std::int64_t mode = in.take(2);
    if (mode == 0) {
        std::fill(depths.begin(), depths.end(), in.take(bits));
    } else if (mode == 3) {
        for (auto& depth : depths)
            depth = in.take(bits);
    } else {
        const auto a = points();
        const auto b = mode == 2 ? points() : a;
        const auto width = static_cast<unsigned>(in.take(5));
        std::vector<bool> second(w * h);
        if (mode == 2)
            for (unsigned i = 0; i < w * h; ++i)
                second[i] = in.take(1) == 1;
        for (unsigned i = 0; i < w * h; ++i) {
            const double x = i % w, y = i / w;
            const double run_x = mode == 1 && w > 1 ? w - 1.0 : 1.0;
            const double run_y = mode == 1 && h > 1 ? h - 1.0 : 1.0;
            depths[i] = (second[i] ? on_plane(b, w - 1.0 - x, h - 1.0 - y)
                                   : on_plane(a, x / run_x, y / run_y)) +
                        in.take_signed(width);
        }
    }
    return depths;
}

std::vector<unsigned> channels(Format format) {
    switch (format) {
    case Format::Rgb565:
        return {5, 6, 5};
    case Format::Rgba4:
        return {4, 4, 4, 4};
    case Format::Rgb5a1:
        return {1, 5, 5, 5};
    case Format::Luminance8:
        return {8};
    case Format::LuminanceAlpha8:
        return {8, 8};
    default:
        return {8, 8, 8, 8};
    }
}

Words reference_sample(Bits& in, const BlockShape& shape) {
    const unsigned w = shape.width, count = shape.width * shape.height;
    Words words(count);
    if (format_info(shape.format).is_depth) {
        const bool stencil = shape.format == Format::Depth24Stencil8;
        const auto depths = reference_depths(in, w, shape.height, stencil ? 24 : 16);
        std::int64_t value = 0;
        const bool uniform = stencil && in.take(1) == 1;
        for (unsigned i = 0; i < count; ++i) {
            if (stencil && (i == 0 || !uniform)) value = in.take(8);
            words[i] = static_cast<std::uint32_t>(stencil ? depths[i] * 256 + value : depths[i]);
        }
        return words;
    }
    unsigned shift = 0;
    for (const unsigned bits : channels(shape.format)) {
        const bool steps = in.take(1) == 1;
        const std::int64_t base = in.take(bits);
        const auto width = static_cast<unsigned>(in.take(4));
        std::vector<std::int64_t> values(count);
        for (unsigned i = 0; i < count; ++i) {
            if (!steps)
                values[i] = base + in.take(width);
            else if (i == 0)
                values[i] = base;
            else
                values[i] =
                    (values[i % w == 0 ? i - w : i - 1] + in.take_signed(width) + (1 << bits)) %
                    (1 << bits);
            words[i] |= static_cast<std::uint32_t>(values[i]) << shift;
        }
        shift += bits;
    }
    return words;
}

// --- Blocks ------------------------------------------------------------------------------------

std::vector<std::byte> bytes_of(const BlockShape& shape, const std::vector<Words>& samples) {
    std::vector<std::byte> bytes(shape.bytes());
    for (std::size_t s = 0; s < samples.size(); ++s)
        for (std::size_t i = 0; i < samples[s].size(); ++i)
            std::memcpy(&bytes[(i * samples.size() + s) * shape.sample_bytes()],
                        &samples[s][i],
                        shape.sample_bytes());
    return bytes;
}

std::vector<std::uint8_t> check_code(const BlockShape& shape, const std::vector<Words>& samples) {
    const auto bytes = bytes_of(shape, samples);
    std::vector<std::uint8_t> code = encode_block(shape, bytes);
    std::vector<std::byte> back(bytes.size());
    decode_block(shape, code, back);
    REQUIRE((back == bytes));
    Bits in(code);
    std::vector<Words> reference{reference_sample(in, shape)};
    while (reference.size() < samples.size())
        reference.push_back(in.take(1) == 1 ? reference[0] : reference_sample(in, shape));
    REQUIRE((reference == samples));
    CHECK((in.taken() + 7) / 8 == code.size());
    return code;
}

constexpr std::uint32_t mask_of(std::uint32_t bytes) {
    return bytes == 4 ? ~0u : (1u << 8 * bytes) - 1;
}

const std::vector<Format> Formats{Format::Depth24Stencil8,
                                  Format::Depth16,
                                  Format::Rgba8,
                                  Format::Rgbx8,
                                  Format::Rgb565,
                                  Format::Rgba4,
                                  Format::Rgb5a1,
                                  Format::Luminance8,
                                  Format::LuminanceAlpha8};

// One of several kinds of content, from noise to all alike.
std::uint32_t random_word(std::mt19937& random, unsigned kind, unsigned x, unsigned y) {
    const auto noise = static_cast<std::uint32_t>(random());
    switch (kind) {
    case 0:
        return noise;
    case 1:
        return 0x12345678 + noise % 4;
    case 2:
        return 0x7fff0000u + 0x10307 * x + 0x2203 * y + noise % 2;
    case 3:
        return x > y ? 0xffffff00u : 0x40000000u + 0x100000 * x;
    case 4:
        return (noise & 1) != 0 ? 0xffffffffu : 0u;
    default:
        return 0xa5a5a5a5u;
    }
}

TEST_CASE("Blocks of any content, shape and format decode to their bytes, by both decoders") {
    std::mt19937 random(1);
    std::size_t codes = 0;
    for (const Format format : Formats)
        for (const auto& [w, h] : {std::pair{4u, 4u},
                                   {8u, 8u},
                                   {16u, 1u},
                                   {1u, 8u},
                                   {2u, 2u},
                                   {8u, 2u},
                                   {1u, 1u},
                                   {128u, 1u}})
            for (const std::uint32_t samples : {1u, 4u})
                for (unsigned kind = 0; kind < 6; ++kind)
                    for (unsigned repeat = 0; repeat < 12; ++repeat) {
                        const BlockShape shape{format, w, h, samples};
                        std::vector<Words> content(samples, Words(w * h));
                        for (unsigned s = 0; s < samples; ++s)
                            for (unsigned i = 0; i < w * h; ++i)
                                content[s][i] = random_word(random, kind, i % w, i / w) &
                                                mask_of(shape.sample_bytes());
                        if (repeat % 3 == 0)
                            for (unsigned s = 1; s < samples; ++s)
                                content[s] = content[0];
                        check_code(shape, content);
                        ++codes;
                    }
    CHECK(codes == Formats.size() * 8 * 2 * 6 * 12);
}

TEST_CASE("All blocks of two by one pixels of 16 bits, of some hundred values each, come back") {
    const BlockShape shape{Format::Depth16, 2, 1, 1};
    for (std::uint32_t a = 0; a < 0x10000; a += 257)
        for (std::uint32_t b = 0; b < 0x10000; b += 255)
            check_code(shape, {{a, b}});
}

std::size_t bytes(std::size_t bits) {
    return (bits + 7) / 8;
}

TEST_CASE("Sizes are those of the closed forms") {
    const BlockShape depth{Format::Depth24Stencil8, 4, 4, 1};
    Words words(16, 0xffffff07);
    CHECK(check_code(depth, {words}).size() == bytes(2 + 24 + 1 + 8));
    // A plane with the corners as told: no residual; then one of 1 step up, of 2 bits.
    for (unsigned i = 0; i < 16; ++i)
        words[i] = (1000 + 300 * (i % 4) + 90 * (i / 4)) << 8;
    CHECK(check_code(depth, {words}).size() == bytes(2 + 3 * 24 + 5 + 0 + 9));
    words[5] += 1 << 8;
    CHECK(check_code(depth, {words}).size() == bytes(2 + 3 * 24 + 5 + 16 * 2 + 9));
    // Two planes.
    for (unsigned i = 0; i < 16; ++i)
        words[i] = (i % 4 + i / 4 < 3 ? 1000 + 300 * (i % 4) : 9000000 + 7 * (i / 4)) << 8;
    CHECK(check_code(depth, {words}).size() == bytes(2 + 6 * 24 + 5 + 16 + 0 + 9));
    // Stencil values that differ take 8 bits each.
    for (unsigned i = 0; i < 16; ++i)
        words[i] = 0xabcdef00 + i;
    CHECK(check_code(depth, {words}).size() == bytes(2 + 24 + 1 + 16 * 8));
    // Noise is no smaller than it was: of no use.
    std::mt19937 random(3);
    for (std::uint32_t& word : words)
        word = static_cast<std::uint32_t>(random());
    CHECK(check_code(depth, {words}).size() == bytes(2 + 16 * 24 + 1 + 16 * 8));

    const BlockShape color{Format::Rgba8, 4, 4, 1};
    CHECK(check_code(color, {Words(16, 0x80402010)}).size() == bytes(4 * (1 + 8 + 4)));
    for (unsigned i = 0; i < 16; ++i)
        words[i] = 0x80402010 + (i % 4 == 2 ? 3 : 0); // red: offsets of 2 bits
    CHECK(check_code(color, {words}).size() == bytes(4 * (1 + 8 + 4) + 16 * 2));
    for (unsigned i = 0; i < 16; ++i)
        words[i] = 0x80402000 + 10 * (i % 4) + 3 * (i / 4); // steps of 5 bits, or offsets of 6
    CHECK(check_code(color, {words}).size() == bytes(4 * (1 + 8 + 4) + 15 * 5));
    // Samples that are alike take a bit each.
    const BlockShape samples{Format::Rgba8, 4, 4, 4};
    CHECK(check_code(samples, std::vector<Words>(4, Words(16, 1))).size() ==
          bytes(4 * (1 + 8 + 4) + 3));
}

} // namespace
} // namespace ffgpu::work
