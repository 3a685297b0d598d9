// The memory that pictures reach the X server through, as the kernel lists it.

// clang-format off: before the macros of X.
#include "tests/window_system/glx_fixture.h"
#include "tests/window_system/run_program.h"
// clang-format on

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ffgpu::tests {
namespace {

struct Segment {
    long creator = 0, attached = 0; // the process, and how many there are that hold it
};

std::vector<Segment> segments_of(long process) {
    std::ifstream file("/proc/sysvipc/shm");
    std::vector<Segment> found;
    std::string line;
    std::getline(file, line); // names: key shmid perms size cpid lpid nattch ...
    REQUIRE(file);
    while (std::getline(file, line)) {
        std::istringstream row(line);
        std::string skipped;
        Segment segment;
        row >> skipped >> skipped >> skipped >> skipped >> segment.creator;
        row >> skipped >> segment.attached;
        if (segment.creator == process) found.push_back(segment);
    }
    return found;
}

TEST_CASE("a window's pictures reach the server through memory that both hold") {
    Display* const display = XServer::display();
    if (!display) return;
    const std::size_t before = segments_of(::getpid()).size();
    const GLXFBConfig config = choose(display, true);
    const TestWindow window(display, config, 64, 48);
    const GLXContext context = glXCreateNewContext(display, config, GLX_RGBA_TYPE, nullptr, True);
    REQUIRE(glXMakeCurrent(display, window.id(), context));
    glClear(GL_COLOR_BUFFER_BIT);
    glXSwapBuffers(display, window.id());
    const std::vector<Segment> segments = segments_of(::getpid());
    REQUIRE(segments.size() == before + 1);
    CHECK(segments.back().attached == 2);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
}

TEST_CASE("a program that is killed before the server holds its memory leaves none") {
    Display* const display = XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const Outcome run = ffgpu_run("-- " FFGPU_FRAMES " attach");
    INFO(run.text);
    CHECK(run.status == 128 + SIGKILL); // It came as far as that.
    const std::string word = "process ";
    const std::size_t at = run.text.find(word);
    REQUIRE(at != std::string::npos);
    CHECK(segments_of(std::stol(run.text.substr(at + word.size()))).empty());
}

} // namespace
} // namespace ffgpu::tests
