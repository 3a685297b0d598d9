// The calls that fragments come from, where the driver draws what several of them gave together.

#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"
#include "tools/explain/explain.h"

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

// A window of 16x16 pixels, and calls without their numbers.
class Program {
public:
    Program() {
        writer_.enter(0, "glXCreateContext", {"dpy", "vis", "shareList", "direct"});
        writer_.end();
        writer_.leave(writer_.calls++);
        writer_.result();
        writer_.pointer(0x1000);
        writer_.end();
        call(1, "glXMakeCurrent", {"dpy", "drawable", "ctx"}, {0, 5, 0x1000});
        call(2, "glViewport", {"x", "y", "width", "height"}, {0, 0, 16, 16});
    }

    void begin(std::int64_t mode) { call(3, "glBegin", {"mode"}, {mode}); }
    // Returns the call's number.
    std::uint64_t vertex(float x, float y) {
        writer_.call(4,
                     "glVertex2f",
                     {"x", "y"},
                     Values{[&] { writer_.float32(x); }, [&] { writer_.float32(y); }});
        return writer_.calls - 1;
    }
    void end() { call(5, "glEnd", {}, {}); }
    std::uint64_t clear() {
        call(6, "glClear", {"mask"}, {0x4000});
        return writer_.calls - 1;
    }
    void swap() { call(7, "glXSwapBuffers", {"dpy", "drawable"}, {0, 5}); }

    const std::string& bytes() const { return writer_.bytes; }

private:
    using Values = std::vector<std::function<void()>>;

    void call(std::uint64_t id,
              const char* name,
              const std::vector<std::string>& names,
              const std::vector<std::int64_t>& arguments) {
        Values values;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            values.push_back([this, &names, &arguments, i] {
                if (names[i] == "ctx")
                    writer_.pointer(static_cast<std::uint64_t>(arguments[i]));
                else
                    writer_.sint(arguments[i]);
            });
        writer_.call(id, name, names, values);
    }

    trace::TraceWriter writer_;
};

constexpr std::int64_t Triangles = 4, TriangleStrip = 5;

const CallName& last_call(const ExplainedFrame& frame, unsigned x, unsigned y) {
    static PixelHistory history;
    history = frame.histories({{x, y}}).front();
    REQUIRE_FALSE(history.events.empty());
    return history.events.back().call;
}

TEST_CASE("a fragment's call is the one that gave the last vertex of its primitive") {
    Program program;
    const std::uint64_t clear = program.clear();
    std::array<std::uint64_t, 4> last{};
    // Lower left and upper right half of the lower left quarter, in two pairs; then two triangles
    // in one pair at the lower right; then a strip at the upper left.
    program.begin(Triangles);
    program.vertex(-1, -1);
    program.vertex(0, -1);
    last[0] = program.vertex(-1, 0);
    program.end();
    program.begin(Triangles);
    program.vertex(0, -1);
    program.vertex(0, 0);
    last[1] = program.vertex(-1, 0);
    program.vertex(0, -1);
    program.vertex(1, -1);
    last[2] = program.vertex(1, 0);
    program.end();
    program.begin(TriangleStrip);
    program.vertex(-1, 0);
    program.vertex(0, 0);
    program.vertex(-1, 1);
    last[3] = program.vertex(0, 1);
    program.end();
    program.swap();
    const TemporaryFile file(trace::in_snappy(program.bytes()));
    const ExplainedFrame frame({.input = file.path(), .frame = 0});
    CHECK(last_call(frame, 0, 15).number == last[0]);
    CHECK(last_call(frame, 0, 15).name == "glVertex2f");
    CHECK(last_call(frame, 7, 8).number == last[1]);
    CHECK(last_call(frame, 15, 15).number == last[2]);
    CHECK(last_call(frame, 0, 7).number == last[3]); // The strip's last, of each triangle.
    CHECK(last_call(frame, 7, 0).number == last[3]);
    CHECK(last_call(frame, 15, 0).number == clear);
    CHECK(last_call(frame, 15, 0).name == "glClear");
}

} // namespace
} // namespace ffgpu::tools
