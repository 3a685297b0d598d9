// draw_pixels.csv: which pixels each draw covers, and which it writes.

#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/scene_trace.h"
#include "tests/tools/tool.h"
#include "tools/record/draw_pixels.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

// A square of `size` pixels from pixel (from, from) on.
void square(SceneTrace& scene, int from, int size) {
    constexpr float Half = SceneTrace::Size / 2;
    const float begin = static_cast<float>(from) / Half - 1;
    const float end = static_cast<float>(from + size) / Half - 1;
    scene.call("glRectf", begin, begin, end, end);
}

TEST_CASE("draw_pixels.csv tells what a draw wrote, and what a test took from it") {
    SceneTrace scene;
    scene.call("glEnable", GlEnum{0x0b71}); // The second square is not nearer than the first.
    scene.call("glClear", GlEnum{0x4100});
    square(scene, 0, 10);
    scene.call("glShadeModel", GlEnum{0x1d00}); // What has another state is another draw.
    square(scene, 5, 10);
    scene.swap();
    const TemporaryFolder folder;
    const TemporaryFile file(scene.file());
    REQUIRE(run({"replay", file.path(), "-o", folder / "out", "--draw-pixels"}) == 0);
    CHECK(content(folder / "out/draw_pixels.csv") ==
          "frame,kind,draw,fragments_covered,fragments_written,left,top,width,height,pixels\n"
          "0,draw,0,100,100,0,22,10,10,w100\n"
          "0,draw,1,100,75,5,17,10,10,w50k5w5k5w5k5w5k5w5k5w5\n");
}

TEST_CASE("--draw-pixels needs a folder, and one that can be written") {
    SceneTrace scene;
    square(scene, 0, 10);
    scene.swap();
    const TemporaryFile file(scene.file());
    CHECK(run({"replay", file.path(), "--draw-pixels"}) == 2);
    CHECK_THROWS_AS(DrawPixels("/no such folder/draw_pixels.csv"), InputError);
}

TEST_CASE("runs of pixels are letters with how often they come") {
    using enum DrawnPixel;
    CHECK(pixel_runs({}).empty());
    CHECK(pixel_runs({None, Written, Written, Killed, None, None}) == "n1w2k1n2");
}

} // namespace
} // namespace ffgpu::tools
