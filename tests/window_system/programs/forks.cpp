// A GLX program that draws ten frames and forks children which end by exit(): one before the first
// frame, that lives on while frames are drawn, and one between two frames. With "exec" it also
// starts a program that draws while it does.

#include "tests/window_system/programs/drawing.h"

#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using ffgpu::tests::Drawing;

constexpr int Frames = 10, ForkAfter = 4;

// Another program, started before the first call of OpenGL: it draws a frame when its standard
// input ends.
pid_t start_program(const char* self, int input) {
    const pid_t process = ::fork();
    if (process != 0) return process;
    ::dup2(input, STDIN_FILENO);
    ::execl(self, self, "child", nullptr);
    std::_Exit(EXIT_FAILURE);
}

int draw_when_told() {
    char none = 0;
    if (::read(STDIN_FILENO, &none, 1) != 0) return EXIT_FAILURE;
    const Drawing drawing;
    drawing.frame(0);
    return EXIT_SUCCESS;
}

bool succeeded(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

} // namespace

int main(int count, char** arguments) {
    const std::string mode = count > 1 ? arguments[1] : "";
    if (mode == "child") return draw_when_told();
    int ends[2], tell[2];
    if (::pipe(ends) != 0 || ::pipe2(tell, O_CLOEXEC) != 0) return 2;
    const pid_t program = mode == "exec" ? start_program(arguments[0], tell[0]) : 0;
    const Drawing drawing;

    const pid_t early = ::fork();
    if (early == 0) {
        ::close(ends[1]);
        ::close(tell[1]);
        char none = 0;
        const bool parent_is_done = ::read(ends[0], &none, 1) == 0;
        std::exit(parent_is_done ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    for (int i = 0; i < Frames; ++i) {
        drawing.frame(i);
        if (i != ForkAfter) continue;
        const pid_t child = ::fork();
        if (child == 0) std::exit(EXIT_SUCCESS);
        ::waitpid(child, nullptr, 0);
        ::close(tell[1]);
        if (program != 0 && !succeeded(program)) return EXIT_FAILURE;
    }
    ::close(ends[1]);
    for (XEvent event; mode == "wait";)
        XNextEvent(drawing.display, &event);
    return succeeded(early) ? EXIT_SUCCESS : EXIT_FAILURE;
}
