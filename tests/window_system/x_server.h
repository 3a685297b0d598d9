// XServer: an Xvfb of the test's own. Tests that need one say nothing more where there is none.

#pragma once

// clang-format off: before the macros of X.
#include <catch2/catch.hpp>
// clang-format on

#include <csignal>
#include <cstdlib>
#include <string>

#include <X11/Xlib.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tests {

class XServer {
public:
    // The one of this test program; null: Xvfb is not installed.
    static Display* display() {
        static XServer server;
        if (!server.display_) WARN("Xvfb is missing: this test is skipped");
        return server.display_;
    }

private:
    XServer() {
        int ends[2];
        if (::pipe(ends) != 0) return;
        process_ = ::fork();
        if (process_ == 0) {
            const std::string number = std::to_string(ends[1]);
            const int nowhere = ::open("/dev/null", O_WRONLY);
            ::dup2(nowhere, STDOUT_FILENO);
            ::dup2(nowhere, STDERR_FILENO);
            ::prctl(PR_SET_PDEATHSIG, SIGTERM); // Even if the test crashes.
            ::execlp("Xvfb",
                     "Xvfb",
                     "-displayfd",
                     number.c_str(),
                     "-screen",
                     "0",
                     "640x480x24",
                     "-noreset",
                     "-nolisten",
                     "tcp",
                     nullptr);
            std::_Exit(127);
        }
        ::close(ends[1]);
        std::string name = ":";
        for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';)
            name += c;
        ::close(ends[0]);
        if (name.size() > 1) display_ = XOpenDisplay(name.c_str());
    }
    ~XServer() {
        if (display_) XCloseDisplay(display_);
        if (process_ <= 0) return;
        ::kill(process_, SIGTERM);
        ::waitpid(process_, nullptr, 0);
    }

    pid_t process_ = -1;
    Display* display_ = nullptr;
};

} // namespace ffgpu::tests
