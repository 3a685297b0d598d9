// Completeness (GL 1.5, 3.8.10) and the chain of levels in device memory.

#include "driver/lower/sampler.h"
#include "driver/lower/texture_image.h"
#include "driver/objects/completeness.h"
#include "driver/texture/residency.h"
#include "tests/driver/recording_device.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;

namespace {

struct Size {
    GLsizei width = 1, height = 1, depth = 1;
};

struct Textures {
    RecordingDevice device;
    std::shared_ptr<MemoryAllocator> allocator =
        std::make_shared<MemoryAllocator>(0, device.memory_size());
    DeviceMemory memory{device, allocator};

    void define(TextureObject& texture,
                ImageName name,
                Size size,
                GLenum internal_format = GL_RGBA,
                GLint border = 0) {
        TextureLevel level;
        level.internal_format = internal_format;
        level.format = texture_format(internal_format);
        level.width = size.width + 2 * border;
        level.height = texture.target() == TextureTarget::OneD ? 1 : size.height + 2 * border;
        level.depth = texture.target() == TextureTarget::ThreeD ? size.depth + 2 * border : 1;
        level.border = border;
        std::vector<std::byte> texels(box_bytes(level.format.format, whole_box(level)),
                                      static_cast<std::byte>(name.level + 1));
        define_image(memory, texture, name, level, std::move(texels));
    }

    // Levels of a two-dimensional texture, each half the one before.
    void define_chain(TextureObject& texture, Size size, unsigned levels) {
        for (unsigned level = 0; level < levels; ++level) {
            define(texture,
                   {0, level},
                   {std::max(size.width >> level, 1), std::max(size.height >> level, 1)});
        }
    }
};

} // namespace

TEST_CASE_METHOD(Textures, "without images a texture is incomplete") {
    TextureObject texture(1, TextureTarget::TwoD);
    CHECK_FALSE(texture.chain().complete);
    CHECK_FALSE(make_resident(memory, texture));
}

TEST_CASE_METHOD(Textures, "a mip map filter needs all levels down to one texel, others do not") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {16, 4}, 4); // 16x4 8x2 4x1 2x1
    CHECK_FALSE(texture.chain().complete);
    texture.parameters.min_filter = GL_LINEAR;
    texture.changed();
    CHECK(texture.chain().complete);
    texture.parameters.min_filter = GL_NEAREST_MIPMAP_NEAREST;
    define(texture, {0, 4}, {1, 1});
    CHECK(texture.chain().complete);
    CHECK(texture.chain().last == 4);
}

TEST_CASE_METHOD(Textures, "the maximum level ends the chain early") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {16, 16}, 3);
    texture.parameters.max_level = 2;
    texture.changed();
    CHECK(texture.chain().complete);
    texture.parameters.max_level = 3;
    texture.changed();
    CHECK_FALSE(texture.chain().complete);
}

TEST_CASE_METHOD(Textures,
                 "a base level above the maximum level is incomplete with mip maps only") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {4, 4}, 3);
    texture.parameters.base_level = 2;
    texture.parameters.max_level = 1;
    texture.changed();
    CHECK_FALSE(texture.chain().complete);
    texture.parameters.min_filter = GL_NEAREST;
    texture.changed();
    CHECK(texture.chain().complete);
}

TEST_CASE_METHOD(Textures, "a level of another size, format or border breaks the chain") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {8, 8}, 4);
    REQUIRE(texture.chain().complete);
    SECTION("size") {
        define(texture, {0, 1}, {4, 2});
    }
    SECTION("format") {
        define(texture, {0, 1}, {4, 4}, GL_RGBA8);
    }
    SECTION("border") {
        define(texture, {0, 1}, {4, 4}, GL_RGBA, 1);
    }
    CHECK_FALSE(texture.chain().complete);
    CHECK(texture.chain().shape.levels == 1);
}

TEST_CASE_METHOD(Textures, "sizes that are no powers of two are halved rounding down") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {13, 5}, 4); // 13x5 6x2 3x1 1x1
    CHECK(texture.chain().complete);
}

TEST_CASE_METHOD(Textures, "a cube map needs six equal squares") {
    TextureObject texture(1, TextureTarget::Cube);
    texture.parameters.min_filter = GL_LINEAR;
    for (unsigned face = 0; face < 5; ++face)
        define(texture, {face, 0}, {4, 4});
    CHECK_FALSE(texture.chain().complete);
    define(texture, {5, 0}, {4, 4});
    CHECK(texture.chain().complete);
    define(texture, {2, 0}, {2, 2});
    CHECK_FALSE(texture.chain().complete);
}

TEST_CASE_METHOD(Textures, "resident levels lie where the layout says, from the base level on") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {8, 8}, 4);
    REQUIRE(make_resident(memory, texture));
    CHECK(texture.level(0, 0).texels.empty());
    const TextureImage whole = lower_texture_image(texture);
    CHECK(whole.shape.levels == 4);
    for (std::uint32_t level = 0; level < 4; ++level) {
        const auto at = whole.address + level_layout(whole.shape, level).offset;
        CHECK(std::to_integer<unsigned>(device.memory[at]) == level + 1);
    }
    texture.parameters.base_level = 2;
    texture.changed();
    REQUIRE(make_resident(memory, texture));
    const TextureImage based = lower_texture_image(texture);
    CHECK(based.shape.width == 2);
    CHECK(based.shape.levels == 2);
    CHECK(std::to_integer<unsigned>(device.memory[based.address]) == 3);
    CHECK(based.address == whole.address + level_layout(whole.shape, 2).offset); // Nothing moved.
}

TEST_CASE_METHOD(Textures, "an image defined anew with the same size stays where it is") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {8, 8}, 4);
    REQUIRE(make_resident(memory, texture));
    const DeviceAddress address = texture.resident.block.address();
    device.memory[address] = std::byte{99};
    define(texture, {0, 0}, {8, 8});
    CHECK(texture.resident_is_current());
    CHECK(texture.resident.block.address() == address);
    CHECK(std::to_integer<unsigned>(device.memory[address]) == 1);
}

TEST_CASE_METHOD(Textures, "texels survive the growth of the chain, and nothing leaks") {
    {
        TextureObject texture(1, TextureTarget::TwoD);
        texture.parameters.min_filter = GL_LINEAR;
        define_chain(texture, {8, 8}, 1);
        REQUIRE(make_resident(memory, texture));
        device.memory[texture.resident.block.address()] = std::byte{77}; // Drawn to, say.
        define(texture, {0, 1}, {4, 4});
        REQUIRE(make_resident(memory, texture));
        CHECK(std::to_integer<unsigned>(device.memory[texture.resident.block.address()]) == 77);
        CHECK(allocator->bytes_in_use() == 256 + 64);
    }
    CHECK(allocator->bytes_in_use() == 0);
}

TEST_CASE_METHOD(Textures, "a texture that device memory has no room for stays on the host") {
    RecordingDevice small(1024);
    auto small_allocator = std::make_shared<MemoryAllocator>(0, 1024);
    const DeviceMemory tight{small, small_allocator};
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {32, 32}, 6);
    CHECK_FALSE(make_resident(tight, texture));
    CHECK(read_texels(tight, texture, {0, 0}, whole_box(texture.level(0, 0))).size() == 4096);
    CHECK(small_allocator->bytes_in_use() == 0);
}

TEST_CASE_METHOD(Textures, "the sampler holds biases and limits in 1/256 and clamps them") {
    TextureObject texture(1, TextureTarget::TwoD);
    define_chain(texture, {8, 8}, 4);
    texture.parameters.lod_bias = 1.5f;
    texture.parameters.max_lod = 2.25f;
    texture.parameters.max_anisotropy = 40;
    const Sampler sampler = lower_sampler(texture, 0.25f);
    CHECK(sampler.bias == 448);
    CHECK(sampler.min_lod == -16 * 256);
    CHECK(sampler.max_lod == 576);
    CHECK(sampler.max_anisotropy == 16);
    CHECK(sampler.max_level == 3);
    CHECK(lower_sampler(texture, 20).bias == 16 * 256);
}

TEST_CASE_METHOD(Textures, "the border is read as a texel of the format") {
    TextureObject texture(1, TextureTarget::TwoD);
    texture.parameters.border_color = {1, 0.5f, 0.25f, 0};
    const auto border_of = [&](GLenum internal_format) {
        define(texture, {0, 0}, {4, 4}, internal_format);
        return lower_sampler(texture, 0).border_color;
    };
    CHECK(border_of(GL_RGBA) == 0x004080ff);
    CHECK(border_of(GL_RGB) == 0xff4080ff);
    CHECK(border_of(GL_LUMINANCE) == 0xffffffff);
    CHECK(border_of(GL_LUMINANCE_ALPHA) == 0x00ffffff);
    CHECK(border_of(GL_INTENSITY) == 0xffffffff);
    CHECK(border_of(GL_ALPHA) == 0x00000000);
}
