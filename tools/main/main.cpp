#include "tools/commands/command_line.h"

#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace {

// Where a standard stream is closed, the next file would be opened in its place, and what is
// printed would go into it.
void occupy_standard_streams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
        if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) != stream) return;
}

} // namespace

int main(int count, char** arguments) {
    occupy_standard_streams();
    // Whoever reads no further (ffgpu export ... | head) ends ffgpu without a word, also where the
    // shell that started it ignores the signal, as those of some schedulers do.
    std::signal(SIGPIPE, SIG_DFL);
    return ffgpu::tools::run_command_line(count, arguments, FFGPU_VERSION);
}
