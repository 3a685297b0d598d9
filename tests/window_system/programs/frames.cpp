// A GLX program whose frames never end well. "noise": pictures that take long to write, and while
// they are written children that call exit(). "killed": ten frames, another one later, then
// SIGKILL. "endless": frames until somebody ends it.

#include "tests/window_system/programs/drawing.h"

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

using ffgpu::tests::Drawing;

constexpr unsigned Size = 200;

void noise() {
    const Drawing drawing(Size);
    std::vector<std::uint8_t> pixels(4 * Size * Size);
    std::uint32_t state = 1;
    for (int frame = 0; frame < 40; ++frame) {
        for (std::uint8_t& value : pixels) {
            state = state * 1664525u + 1013904223u;
            value = static_cast<std::uint8_t>(state >> 24);
        }
        glDrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        drawing.swap();
        for (int child = 0; child < 6; ++child) {
            ::usleep(700);
            const pid_t process = ::fork();
            if (process == 0) std::exit(EXIT_SUCCESS);
            ::waitpid(process, nullptr, 0);
        }
    }
}

void killed() {
    const Drawing drawing;
    for (int frame = 0; frame < 10; ++frame)
        drawing.frame(frame);
    ::usleep(1'500'000); // More than statistics may be old.
    drawing.frame(10);
    std::raise(SIGKILL);
}

void endless() {
    const Drawing drawing;
    for (int frame = 0;; ++frame) {
        drawing.frame(frame % 10);
        ::usleep(1000);
    }
}

} // namespace

int main(int count, char** arguments) {
    const std::string mode = count > 1 ? arguments[1] : "";
    if (mode == "noise") noise();
    if (mode == "killed") killed();
    if (mode == "endless") endless();
    return EXIT_SUCCESS;
}
