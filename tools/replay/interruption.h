// Interruption: Ctrl-C, SIGTERM or the terminal's end while it lives: the frame that is being drawn
// is the last, and what is there is completed. A second signal ends the process at once.

#pragma once

namespace ffgpu::tools {

class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    // The signal that came; 0: none.
    static int signal();

    // The exit status: of work that was interrupted 128 + the signal, as the shell says it.
    static int status(int of_whole_work);
};

} // namespace ffgpu::tools
