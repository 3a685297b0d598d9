#include "driver/texel/block_codec.h"

#include "driver/texel/fxt1.h"
#include "driver/texel/internal_format.h"
#include "driver/texel/s3tc.h"
#include "model/arith/fxt1.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::gl {

namespace {

struct S3tcCodec {
    static constexpr std::uint32_t Width = 4;
    using Texels = TexelBlock;

    static Texels decode(Format format, const std::byte* block) {
        return decode_block(format, block);
    }
    static void encode(Format format, const Texels& texels, std::byte* block) {
        encode_block(format, texels, block);
    }
};

struct Fxt1Codec {
    static constexpr std::uint32_t Width = 8;
    using Texels = Fxt1Texels;

    static Texels decode(Format format, const std::byte* block) {
        Texels texels;
        for (unsigned i = 0; i < texels.size(); ++i)
            texels[i] = decode_fxt1(block, i % Width, i / Width, format == Format::Fxt1Rgba);
        return texels;
    }
    static void encode(Format format, const Texels& texels, std::byte* block) {
        encode_fxt1(texels, format == Format::Fxt1Rgba, block);
    }
};

// Calls visitor(block number, x, y, z) with the first texel of each block.
template <std::uint32_t Width, class Visitor>
void for_each_block(BlockImageSize size, Visitor&& visitor) {
    std::size_t block = 0;
    for (std::uint32_t z = 0; z < size.depth; ++z) {
        for (std::uint32_t y = 0; y < size.height; y += 4) {
            for (std::uint32_t x = 0; x < size.width; x += Width)
                visitor(block++, x, y, z);
        }
    }
}

std::size_t texel_offset(BlockImageSize size, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return 4 * ((std::size_t{z} * size.height + y) * size.width + x);
}

template <class Codec>
void compress_with(Format format, const std::byte* rgba, BlockImageSize size, std::byte* blocks) {
    constexpr std::uint32_t Width = Codec::Width;
    const std::size_t bytes = format_info(format).block_bytes;
    for_each_block<Width>(size, [&](std::size_t number, auto x, auto y, auto z) {
        typename Codec::Texels texels;
        for (std::uint32_t i = 0; i < texels.size(); ++i) {
            const std::uint32_t column = std::min(x + i % Width, size.width - 1);
            const std::uint32_t row = std::min(y + i / Width, size.height - 1);
            std::memcpy(texels[i].data(), rgba + texel_offset(size, column, row, z), 4);
        }
        Codec::encode(format, texels, blocks + number * bytes);
    });
}

template <class Codec>
void decompress_with(Format format, const std::byte* blocks, BlockImageSize size, std::byte* rgba) {
    constexpr std::uint32_t Width = Codec::Width;
    const std::size_t bytes = format_info(format).block_bytes;
    for_each_block<Width>(size, [&](std::size_t number, auto x, auto y, auto z) {
        const typename Codec::Texels texels = Codec::decode(format, blocks + number * bytes);
        for (std::uint32_t i = 0; i < texels.size(); ++i) {
            const std::uint32_t column = x + i % Width, row = y + i / Width;
            if (column >= size.width || row >= size.height) continue;
            std::memcpy(rgba + texel_offset(size, column, row, z), texels[i].data(), 4);
        }
    });
}

} // namespace

std::vector<std::byte> compress(Format format, const std::byte* rgba, BlockImageSize size) {
    const std::size_t layer =
        std::size_t{row_bytes(format, size.width)} * block_rows(format, size.height);
    std::vector<std::byte> blocks(layer * size.depth);
    if (is_fxt1(format)) {
        compress_with<Fxt1Codec>(format, rgba, size, blocks.data());
    } else {
        compress_with<S3tcCodec>(format, rgba, size, blocks.data());
    }
    return blocks;
}

std::vector<std::byte> decompress(Format format, const std::byte* blocks, BlockImageSize size) {
    std::vector<std::byte> rgba(std::size_t{4} * size.width * size.height * size.depth);
    if (is_fxt1(format)) {
        decompress_with<Fxt1Codec>(format, blocks, size, rgba.data());
    } else {
        decompress_with<S3tcCodec>(format, blocks, size, rgba.data());
    }
    return rgba;
}

} // namespace ffgpu::gl
