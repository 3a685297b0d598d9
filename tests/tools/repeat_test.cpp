// The last frame of a trace, played again and again: calls with arrays of numbers among others.

#include "model/gpu/functional_gpu.h"
#include "tests/support/temporary_file.h"
#include "tests/tools/scene_trace.h"
#include "tools/frames/frame_source.h"

#include <set>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::tools;

namespace {

constexpr GlEnum Triangles{4}, Front{0x0404}, Diffuse{0x1201}, Lighting{0x0b50}, Light0{0x4000};

// Of a lit triangle whose position, normal, matrix and materials are arrays; of more numbers than
// the call takes, of fewer, and of one.
std::string arrays_trace() {
    SceneTrace trace;
    constexpr GlEnum ModelView{0x1700}, ColorBuffer{0x4000}, Shininess{0x1601};
    trace.call("glEnable", Lighting);
    trace.call("glEnable", Light0);
    trace.call("glMatrixMode", ModelView);
    trace.call("glClear", ColorBuffer);
    trace.call("glLoadMatrixf",
               std::vector<float>{0.5f, 0, 0, 0, 0, 0.75f, 0, 0, 0, 0, 1, 0, 0.1f, 0, 0, 1});
    trace.call("glBegin", Triangles);
    trace.call("glMaterialfv", Front, Shininess, std::vector<float>{20});
    for (const float x : {-1.0f, 1.0f, 0.0f}) {
        trace.call("glMaterialfv", Front, Diffuse, std::vector<float>{x, 0.5f, 1 - x, 1});
        trace.call("glNormal3fv", std::vector<float>{0, 0.6f, 0.8f});
        trace.call("glTexCoord2fv", std::vector<float>{0.5f}); // damaged
        trace.call("glVertex3fv", std::vector<float>{x, x == 0 ? 1.0f : -1.0f, 0, 7});
    }
    trace.call("glEnd");
    trace.swap();
    return trace.file();
}

} // namespace

TEST_CASE("A frame that is played again is the same picture") {
    const TemporaryFile file(arrays_trace());
    FunctionalGpu gpu({.threads = 1});
    const auto source =
        open_frame_source(file.path(), gpu, {.warn = [](const std::string&) {}, .keep_last = true});
    const auto frame = source->next();
    REQUIRE(frame);
    const Surface& picture = frame->picture;
    const auto pixels = [&] {
        std::vector<std::byte> bytes(static_cast<std::size_t>(picture.bytes()));
        gpu.read_memory(picture.address, bytes);
        return bytes;
    };
    const std::vector<std::byte> first = pixels();
    std::set<std::byte> values(first.begin(), first.end());
    CHECK(values.size() > 20); // lit, and not all alike
    REQUIRE_FALSE(source->next());
    for (int i = 0; i < 3; ++i) {
        gpu.write_memory(picture.address, std::vector<std::byte>(first.size()));
        REQUIRE(source->repeat_last());
        REQUIRE(source->repeat_last()); // A window shows two buffers in turn.
        CHECK((pixels() == first));
    }
}
