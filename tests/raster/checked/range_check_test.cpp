// The checks of a build with FFGPU_CHECK_RANGES: a number that the range rule excludes ends the
// program, an ordinary one does not. This program is such a build of the interpolator.

#include "model/arith/range.h"
#include "model/raster/interpolator.h"
#include "tests/raster/raster_helpers.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

static_assert(ChecksRanges);

// Whether a check() ended it.
template <class Action>
bool aborts(Action&& action) {
    const pid_t process = ::fork();
    if (process == 0) {
        std::signal(SIGABRT, SIG_DFL); // Catch has a handler of its own.
        std::fclose(stderr);
        action();
        std::_Exit(0);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

} // namespace

TEST_CASE("a subnormal, an infinity and a NaN are found at any place, ordinary numbers are not") {
    for (const float special : {1e-40f, -1e-40f, INFINITY, -INFINITY, NAN})
        for (const unsigned place : {0u, 3u, 7u}) {
            std::array<float, 8> numbers{0.0f, -0.0f, 0x1p-126f, 0x1.fffffep127f};
            CHECK_FALSE(aborts([&] { check_ordinary(numbers); }));
            numbers[place] = special;
            CHECK(aborts([&] { check_ordinary(numbers); }));
        }
}

TEST_CASE("the interpolator's texture coordinates are checked") {
    SetupContext setup = context();
    setup.layout.tex_coord[0] = 0;
    setup.layout.tex_components[0] = 2;
    setup.layout.count = 2;
    RecordBuffer buffer;
    WindowVertex v[3] = {vertex(0, 0), vertex(4096, 0), vertex(0, 4096)};
    for (WindowVertex& each : v) {
        each.inverse_w = 0.5f;
        each.attributes[0] = each.attributes[1] = 1;
    }
    v[1].inverse_w = 0.25f;
    REQUIRE(buffer.triangle(setup, v[0], v[1], v[2]));
    const BatchRun run{&buffer.record(), 0};
    auto batch = std::make_unique<FragmentBatch>();
    auto coords = std::make_unique<TexCoordPlanes>();
    auto planes = std::make_unique<PerspectivePlanes>();
    batch->quad_count = 1;
    batch->x[0] = batch->y[0] = 2;
    interpolate_perspective({&run, 1}, *batch, *planes);
    const auto draw = [&] {
        interpolate_tex_coords(setup.layout, 0, {&run, 1}, *planes, *batch, *coords);
    };
    CHECK_FALSE(aborts(draw));
    planes->w[2] = INFINITY;
    CHECK(aborts(draw));
}
