// RunMark: the file that FFGPU_MARK names, by which the processes of one `ffgpu run` know of each
// other and `ffgpu run` of them: who draws leaves a byte in it; who is recorded holds its lock, and
// leaves another with the first frame and one when its files are complete.

#pragma once

#include <string>

namespace ffgpu::gl {

class RunMark {
public:
    // This process was started by `ffgpu run`.
    static bool is_there();

    // What the file begins with: each byte is there, so that none wants room on a disk that has
    // become full.
    static std::string blank();

    // This process draws.
    static void leave();

    // This process wants to be recorded. False: another one is, or was and has frames. Without
    // FFGPU_MARK there is nobody else.
    static bool claim();

    // `ffgpu run` has started this process, and has ended since.
    static bool is_over();

    // The process that claimed has a frame.
    static void leave_frame();

    // Its files are complete, or why they are not has been said.
    static void leave_complete();

    // What the file says to `ffgpu run`.
    struct State {
        bool draws = false;    // somebody
        bool complete = false; // who is recorded; so also where nobody is
        bool goes_on = false;  // who is recorded still lives
    };
    static State read(const std::string& path);
};

} // namespace ffgpu::gl
