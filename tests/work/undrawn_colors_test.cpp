// Work of a GPU that draws colours where they decide on fragments alone: the work of one that draws
// all, or it is told that colours were missed.

#include "tests/work/recorded_work.h"

#include <bit>
#include <utility>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

const FunctionalGpu::Config WithoutColors{.colors = false};

// On the left a pane with alpha 10 below, 200 above; then the target is the texture of a pane over
// all, whose alpha is tested.
class CopiedTexture {
public:
    static constexpr std::uint32_t Size = 64;

    explicit CopiedTexture(const FunctionalGpu::Config& host = WithoutColors)
        : scene(Size, Size, host)
        , assembler_(list) {
        scene.gpu.set_work_sink(&assembler_);
        scene.clear(0x05000000);
        pane(-1, 0, 10 / 255.0f);
        pane(0, 1, 200 / 255.0f);
    }

    // Of rows from `bottom` to `top` of the picture.
    void pane(float bottom, float top, float alpha) {
        const auto corner = [&](float x, float y) {
            return test::Vertex{x, y, 0, 1, 1, 1, 1, alpha, 0.5f + 0.5f * x, 0.5f + 0.5f * y};
        };
        scene.draw(PrimitiveType::Quads,
                   {corner(-1, bottom), corner(1, bottom), corner(1, top), corner(-1, top)});
    }
    void make_texture() {
        scene.texture(Size, std::vector<std::uint32_t>(Size * Size, 0xffffffff));
    }
    void copy() {
        const Surface from = scene.registers.targets.color[0];
        Surface to = from;
        to.address = test::TextureAt;
        scene.command(
            CopyRectangleCommand{.source = from, .destination = to, .width = Size, .height = Size});
    }
    void test_alpha() {
        scene.registers.fragment.alpha_test = true;
        scene.registers.fragment.alpha_compare = Compare::Greater;
        scene.registers.fragment.alpha_reference = 100;
        pane(-1, 1, 1);
        scene.gpu.finish();
    }
    bool missed() const { return scene.gpu.missed_colors(); }

    // Of the last draw.
    std::uint64_t written() {
        scene.gpu.finish();
        std::uint64_t fragments = 0;
        for (const WorkQuad& quad : list.commands.back()->quads)
            fragments += static_cast<unsigned>(std::popcount(quad.after_depth));
        return fragments;
    }

    CommandList list;
    test::Scene scene;

private:
    CommandAssembler assembler_;
};

} // namespace

TEST_CASE("The work of a mixture is the same without colours", "[undrawn]") {
    for (const std::uint8_t samples : {std::uint8_t{1}, std::uint8_t{4}}) {
        INFO(int{samples} << " samples");
        const std::string expected = file_of(recorded({}, samples));
        CHECK(file_of(recorded(WithoutColors, samples)) == expected);
        CHECK(file_of(recorded({.threads = 2, .tile_size = 16, .colors = false}, samples)) ==
              expected);
    }
}

TEST_CASE("Colours are left out, but for draws that test them", "[undrawn]") {
    test::Scene scene(64, 64, WithoutColors);
    const std::vector<test::Vertex> triangle{{-1, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                                             {1, -1, 0, 1, 1, 0, 0, 1, 0, 0},
                                             {-1, 1, 0, 1, 1, 0, 0, 1, 0, 0}};
    scene.clear(0xff402000);
    scene.draw(PrimitiveType::Triangles, triangle);
    CHECK(scene.colors() == 1);
    CHECK(scene.gpu.missed_colors()); // The picture was read.
    scene.registers.fragment.alpha_test = true;
    scene.draw(PrimitiveType::Triangles, triangle);
    CHECK(scene.colors() == 2);
}

TEST_CASE("What was copied from a picture without colours decides on no fragment", "[undrawn]") {
    CopiedTexture copied;
    copied.make_texture();
    copied.copy();
    CHECK_FALSE(copied.missed());
    copied.pane(-1, 1, 1); // reads it for its colour
    copied.scene.gpu.finish();
    CHECK_FALSE(copied.missed());
    copied.test_alpha();
    CHECK(copied.missed());
    copied.scene.gpu.reset();
    CHECK_FALSE(copied.missed());

    CopiedTexture with(FunctionalGpu::Config{});
    with.make_texture();
    with.copy();
    with.test_alpha();
    CHECK(with.written() == CopiedTexture::Size * CopiedTexture::Size / 2);
    CHECK_FALSE(with.missed());
}

TEST_CASE("A texture that the host writes is not missed, nor is one of before", "[undrawn]") {
    CopiedTexture written;
    written.make_texture();
    written.copy();
    written.make_texture(); // over what was copied
    written.test_alpha();
    CHECK_FALSE(written.missed());
    CHECK(written.written() == CopiedTexture::Size * CopiedTexture::Size);
}

TEST_CASE("Part of a texture that the host writes leaves the rest missed", "[undrawn]") {
    CopiedTexture part;
    part.make_texture();
    part.copy();
    const std::vector<std::uint32_t> rows(CopiedTexture::Size * 10, 0xffffffff);
    part.scene.gpu.write_memory(test::TextureAt, test::bytes_of(rows));
    part.test_alpha();
    CHECK(part.missed());
}

TEST_CASE("A host that reads the picture, or depths, or vertices", "[undrawn]") {
    CopiedTexture depths;
    depths.scene.depth_buffer();
    CHECK_FALSE(depths.missed());
    depths.scene.picture();
    CHECK(depths.missed());

    CopiedTexture vertices;
    DrawCommand draw;
    draw.primitive = PrimitiveType::Points;
    draw.count = draw.vertex_count = 1;
    draw.vertex_address = test::ColorAt;
    vertices.scene.command(draw);
    CHECK(vertices.missed());
}

TEST_CASE("Depths that lie where colours were left out", "[undrawn]") {
    CopiedTexture copied; // byte by byte
    Surface to = copied.scene.registers.targets.depth;
    to.format = Format::Rgba8;
    copied.scene.command(CopyRectangleCommand{.source = copied.scene.registers.targets.color[0],
                                              .destination = to,
                                              .width = CopiedTexture::Size,
                                              .height = CopiedTexture::Size});
    CHECK_FALSE(copied.missed());
    copied.pane(-1, 1, 1);
    CHECK(copied.missed());

    CopiedTexture again; // memory that is used again
    Targets& targets = again.scene.registers.targets;
    std::swap(targets.color[0].address, targets.depth.address);
    again.pane(-1, 1, 1);
    CHECK(again.missed());

    CopiedTexture together;
    together.scene.registers.targets.depth.address = test::ColorAt;
    together.pane(-1, 1, 1);
    CHECK(together.missed());

    CopiedTexture colors; // where depths were
    colors.scene.registers.targets.color[0].address = test::DepthAt;
    colors.scene.registers.targets.depth.format = Format::None;
    colors.pane(-1, 1, 1);
    CHECK_FALSE(colors.missed());
}

TEST_CASE("An image out of a picture without colours is missed where its alpha is tested, or where "
          "it is depths",
          "[undrawn]") {
    const DrawImageCommand image{.format = Format::Rgba8,
                                 .address = test::ColorAt,
                                 .stride = 4 * CopiedTexture::Size,
                                 .width = 8,
                                 .height = 8};
    CopiedTexture copied;
    copied.scene.command(image);
    CHECK_FALSE(copied.missed());
    copied.scene.registers.fragment.alpha_test = true;
    copied.scene.command(image);
    CHECK(copied.missed());

    CopiedTexture depths;
    DrawImageCommand as_depths = image;
    as_depths.format = Format::Depth24Stencil8;
    depths.scene.command(as_depths);
    CHECK(depths.missed());
}

} // namespace ffgpu::work
