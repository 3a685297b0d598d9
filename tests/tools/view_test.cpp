// `--view`: what each view shows of a square that lies in the middle of the window.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/scene_trace.h"
#include "tests/tools/tool.h"
#include "tools/image/image.h"
#include "tools/views/view.h"

#include <array>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;
using Color = std::array<int, 3>;

constexpr Color Black{0, 0, 0}, White{255, 255, 255}, Red{255, 0, 0};
constexpr GlEnum DepthTest{0x0b71}, StencilTest{0x0b90}, FogOn{0x0b60}, LightingOn{0x0b50},
    Always{0x0207}, Keep{0x1e00}, Replace{0x1e01};

using SetUp = std::function<void(SceneTrace&)>;

// The frame and its view, as the square's inside and the ground around it are.
class Pictures {
public:
    Pictures(const std::string& view, const SetUp& set_up) {
        SceneTrace scene;
        scene.call("glClearColor", 0.0f, 0.0f, 1.0f, 1.0f);
        scene.call("glClear", GlEnum{0x4500}); // colour, depth, stencil
        scene.call("glColor3f", 1.0f, 0.0f, 0.0f);
        set_up(scene);
        scene.call("glRectf", -0.5f, -0.5f, 0.5f, 0.5f);
        scene.swap();
        const TemporaryFolder folder;
        const TemporaryFile file(scene.file());
        REQUIRE(run({"replay", file.path(), "-o", folder / "out", "--view", view}) == 0);
        frame_ = read_image(folder / "out/frame_0000.png");
        view_ = read_image(folder / "out/view_" + view + "_0000.png");
    }
    Color frame() const { return at(frame_, Middle, Middle); }
    Color inside() const { return at(view_, Middle, Middle); }
    Color ground() const { return at(view_, 2, 2); }

    unsigned count(const Color& color) const {
        unsigned found = 0;
        for (unsigned y = 0; y < view_.height; ++y)
            for (unsigned x = 0; x < view_.width; ++x)
                found += at(view_, x, y) == color;
        return found;
    }

private:
    static constexpr unsigned Middle = SceneTrace::Size / 2;

    static Color at(const Image& image, unsigned x, unsigned y) {
        const std::size_t pixel = 3 * (std::size_t{image.width} * y + x);
        return {image.rgb.at(pixel), image.rgb.at(pixel + 1), image.rgb.at(pixel + 2)};
    }

    Image frame_, view_;
};

// A texel of no red on unit 0, sampled at (1/4, 3/4).
void blue_texture(SceneTrace& scene) {
    scene.texture(Rgb, 1, std::string("\x00\x00\xff\x00", 4), Nearest);
    scene.call("glTexCoord2f", 0.25f, 0.75f);
}

TEST_CASE("Wireframe shows the edges in white on black, and nothing inside") {
    const Pictures pictures("wireframe", [](SceneTrace&) {});
    CHECK(pictures.frame() == Red);
    CHECK(pictures.inside() == Black);
    CHECK(pictures.ground() == Black);
    const unsigned white = pictures.count(White);
    CHECK(white + pictures.count(Black) == SceneTrace::Size * SceneTrace::Size);
    CHECK(white >= 60); // Four edges of 16 pixels; corners may be shared.
    CHECK(white <= 64);
}

TEST_CASE("Depth shows what is near bright, and the far plane black") {
    const auto square = [](SceneTrace& scene) { scene.call("glEnable", DepthTest); };
    const Pictures one("depth", square);
    CHECK(one.inside() == White);
    CHECK(one.ground() == Black);
    const Pictures two("depth", [&](SceneTrace& scene) {
        square(scene);
        scene.call("glTranslatef", 0.0f, 0.0f, 0.5f); // away from the viewer
        scene.call("glRectf", -1.0f, -1.0f, 1.0f, 1.0f);
        scene.call("glLoadIdentity");
    });
    CHECK(two.inside() == White);
    CHECK(two.ground() == Color{48, 48, 48});
}

TEST_CASE("Stencil shows the largest value white") {
    const Pictures pictures("stencil", [](SceneTrace& scene) {
        scene.call("glEnable", StencilTest);
        scene.call("glStencilFunc", Always, 3, 255);
        scene.call("glStencilOp", Keep, Keep, Replace);
    });
    CHECK(pictures.inside() == White);
    CHECK(pictures.ground() == Black);
}

TEST_CASE("Normals show half of each component above a half") {
    const auto facing = [](float x, float y, float z) {
        return Pictures("normals", [=](SceneTrace& scene) {
            scene.call("glNormal3f", x, y, z);
            blue_texture(scene);
        });
    };
    const Pictures pictures = facing(0, 0, 1);
    CHECK(pictures.ground() == Black);
    for (const int channel : {0, 1})
        CHECK(std::abs(pictures.inside()[static_cast<std::size_t>(channel)] - 127.5) <= 0.5);
    CHECK(pictures.inside()[2] == 255);
    CHECK(facing(-2, 0, 0).inside()[0] == 0); // Its length does not count.
}

TEST_CASE("Texture coordinates show s as red and t as green, of what is textured") {
    const Pictures pictures("texcoord", blue_texture);
    CHECK(pictures.frame() == Black);
    CHECK(pictures.inside() == Color{64, 192, 0}); // 256 s, 256 t
    CHECK(pictures.ground() == Black);
    CHECK(Pictures("texcoord", [](SceneTrace&) {}).inside() == Black);
}

TEST_CASE("Unlit shows the vertices' colours where lighting replaces them") {
    const Pictures pictures("unlit", [](SceneTrace& scene) { scene.call("glEnable", LightingOn); });
    CHECK(pictures.frame() == Color{10, 10, 10}); // 255 x 0.2 x 0.2: the scene's ambient light
    CHECK(pictures.inside() == Red);
    CHECK(pictures.ground() == Color{0, 0, 255});
}

TEST_CASE("Untextured shows what textures are mixed into") {
    const Pictures pictures("untextured", blue_texture);
    CHECK(pictures.frame() == Black);
    CHECK(pictures.inside() == Red);
}

TEST_CASE("Before fog shows what fog hides") {
    const Pictures pictures("before_fog", [](SceneTrace& scene) {
        scene.call("glEnable", FogOn);
        scene.call("glFogi", GlEnum{0x0b65}, GlEnum{0x2601}); // linear
        scene.call("glFogf", GlEnum{0x0b63}, -1.0f);          // start
        scene.call("glFogf", GlEnum{0x0b64}, 0.0f);           // end: all is fog
    });
    CHECK(pictures.frame() == Black);
    CHECK(pictures.inside() == Red);
}

TEST_CASE("Names of views may have dashes; two are heat maps; unknown ones are refused") {
    CHECK(parse_views("before-fog,depth").views == std::set{View::BeforeFog, View::Depth});
    CHECK(parse_views("level,coverage").heat_maps == std::set{HeatMap::Level, HeatMap::Covered});
    CHECK_THROWS_WITH(parse_views("wirefrane"), Contains("did you mean wireframe?"));
    CHECK(run({"replay", "none.trace", "--capture", "x.ffc", "--view", "depth"}) == 2);
}

TEST_CASE("Views change neither the frame nor its statistics") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(2, true)));
    REQUIRE(run({"replay", file.path(), "-o", folder / "plain", "--timing"}) == 0);
    REQUIRE(run({"replay",
                 file.path(),
                 "-o",
                 folder / "views",
                 "--timing",
                 "--per-draw",
                 "--steps",
                 "1",
                 "--view",
                 "wireframe,depth,stencil,normals,texcoord,unlit,untextured,before-fog"}) == 0);
    CHECK(content(folder / "plain/stats.json") == content(folder / "views/stats.json"));
    CHECK(content(folder / "plain/frame_0001.png") == content(folder / "views/frame_0001.png"));
}

} // namespace
} // namespace ffgpu::tools
