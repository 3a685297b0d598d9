// RunMark: the file that FFGPU_MARK names, by which the processes of one `ffgpu run` know of each
// other and `ffgpu run` of them: who draws leaves a byte in it; who is recorded holds its lock, and
// leaves another with the first frame.

#pragma once

namespace ffgpu::gl {

class RunMark {
public:
    // This process was started by `ffgpu run`.
    static bool is_there();

    // This process draws.
    static void leave();

    // This process wants to be recorded. False: another one is, or was and has frames. Without
    // FFGPU_MARK there is nobody else.
    static bool claim();

    // The process that claimed has a frame.
    static void leave_frame();
};

} // namespace ffgpu::gl
