// Where pixels lie under glPixelStore's parameters (GL 1.5, 3.6.4), and pixel transfer.

#include "driver/pixel/pixel_layout.h"
#include "driver/pixel/pixel_transfer.h"
#include "driver/pixel/unpack.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;

TEST_CASE("rows begin at multiples of the alignment") {
    PixelStore store;
    const ImageSize size{3, 2, 1};
    CHECK(pixel_layout(store, size, GL_RGB, GL_UNSIGNED_BYTE, false).row_stride == 12);
    CHECK(pixel_layout(store, size, GL_RGB, GL_UNSIGNED_BYTE, false).end == 12 + 9);
    store.alignment = 1;
    CHECK(pixel_layout(store, size, GL_RGB, GL_UNSIGNED_BYTE, false).row_stride == 9);
    store.alignment = 8;
    CHECK(pixel_layout(store, size, GL_RGB, GL_UNSIGNED_SHORT, false).row_stride == 24);
    CHECK(pixel_layout(store, {5, 1, 1}, GL_RED, GL_FLOAT, false).row_stride == 24);
}

TEST_CASE("row length, image height and skips move the first pixel") {
    PixelStore store{.row_length = 10,
                     .image_height = 7,
                     .skip_pixels = 2,
                     .skip_rows = 3,
                     .skip_images = 1,
                     .alignment = 4};
    const PixelLayout flat = pixel_layout(store, {4, 2, 1}, GL_RGBA, GL_UNSIGNED_BYTE, false);
    CHECK(flat.row_stride == 40);
    CHECK(flat.first == 3 * 40 + 8);
    CHECK(flat.end == flat.first + 40 + 16);
    const PixelLayout solid = pixel_layout(store, {4, 2, 2}, GL_RGBA, GL_UNSIGNED_BYTE, true);
    CHECK(solid.image_stride == 280);
    CHECK(solid.first == 280 + 3 * 40 + 8);
    CHECK(solid.end == solid.first + 280 + 40 + 16);
}

TEST_CASE("with MESA_pack_invert the last row comes first") {
    const PixelStore store{.skip_rows = 1, .alignment = 4, .invert = true};
    const PixelLayout layout = pixel_layout(store, {3, 4, 2}, GL_RGBA, GL_UNSIGNED_BYTE, true);
    CHECK(layout.row(3) == 12);
    CHECK(layout.row(0) == 4 * 12);
    CHECK(layout.row(0, 1) == 8 * 12);
    CHECK(layout.end == 9 * 12);
}

TEST_CASE("a bitmap's rows are bits") {
    PixelStore store{.skip_pixels = 11, .skip_rows = 1, .alignment = 2};
    const PixelLayout layout = pixel_layout(store, {10, 3, 1}, GL_COLOR_INDEX, GL_BITMAP, false);
    CHECK(layout.row_stride == 2);
    CHECK(layout.first == 2 + 1);
    CHECK(layout.first_bit == 3);
    CHECK(layout.end == layout.first + 2 * 2 + 2);
}

TEST_CASE("bits are read from the highest, or with LSB first from the lowest") {
    const std::uint8_t bits[2] = {0b10010000, 0b00000001};
    PixelStore store{.skip_pixels = 3, .alignment = 1};
    const auto read = [&] {
        const PixelSource source(bits, store, {13, 1, 1}, GL_COLOR_INDEX, GL_BITMAP);
        std::vector<std::int32_t> indices(13);
        unpack_indices(source, source.row(0), indices.data());
        return indices;
    };
    CHECK(read() == std::vector<std::int32_t>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1});
    store.lsb_first = true;
    CHECK(read() == std::vector<std::int32_t>{0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("sizes that no memory can hold do not wrap around to small ones") {
    PixelStore store{.row_length = 2147483647, .skip_rows = 2147483647, .alignment = 8};
    CHECK(pixel_layout(store, {1, 1, 1}, GL_RGBA, GL_FLOAT, false).end == ~std::uint64_t{0});
}

TEST_CASE("colours are scaled and biased, then looked up clamped") {
    PixelState transfer;
    CHECK(keeps_colors(transfer));
    transfer.scale = {2, 1, 1, 1};
    transfer.bias = {0, 0.25f, -1, 0};
    std::array<PixelColor, 1> row{{{0.25f, 0.5f, 0.5f, 1}}};
    transfer_colors(transfer, row);
    CHECK(row[0] == PixelColor{0.5f, 0.75f, -0.5f, 1});
    transfer = {};
    transfer.map_color = true;
    transfer.maps[static_cast<std::size_t>(PixelMapName::RToR)] = {1, 0.5f, 0};
    row[0] = {0.6f, 1, 1, 1};
    transfer_colors(transfer, row);
    CHECK(row[0] == PixelColor{0.5f, 0, 0, 0}); // Round(0.6 * 2) is entry 1; others map to 0.
    CHECK_FALSE(keeps_colors(transfer));
}

TEST_CASE("indices are shifted, offset and turned into colours by the maps") {
    PixelState transfer;
    transfer.index_shift = 1;
    transfer.index_offset = 1;
    transfer.maps[static_cast<std::size_t>(PixelMapName::IToR)] = {0, 0.25f, 0.5f, 0.75f};
    std::array<std::int32_t, 3> row{0, 1, 2}; // 1, 3, 5: of four entries 1, 3, 1.
    std::array<PixelColor, 3> colors;
    transfer_indices(transfer, row, colors.data());
    CHECK(colors[0][0] == 0.25f);
    CHECK(colors[1][0] == 0.75f);
    CHECK(colors[2][0] == 0.25f);
    transfer.index_shift = -1;
    transfer.index_offset = 0;
    std::array<std::int32_t, 2> stencils{5, 4};
    transfer_stencil(transfer, stencils);
    CHECK(stencils == std::array<std::int32_t, 2>{2, 2});
    transfer.map_stencil = true;
    transfer.maps[static_cast<std::size_t>(PixelMapName::SToS)] = {7, 9};
    transfer_stencil(transfer, stencils);
    CHECK(stencils == std::array<std::int32_t, 2>{9, 9});
}
