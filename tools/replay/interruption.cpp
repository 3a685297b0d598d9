#include "tools/replay/interruption.h"

#include "model/base/unfinished_file.h"
#include "tools/replay/one_signal.h"

#include <array>
#include <csignal>

namespace ffgpu::tools {
namespace {

constexpr std::array Signals{SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t came = 0;
OneSignal arrival;

// A second one ends at once, and leaves no half of a file.
void interrupt(int signal) {
    if (!arrival.is_new()) return;
    if (came != 0) {
        UnfinishedFile::remove_all();
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    came = signal;
}

} // namespace

Interruption::Interruption() {
    came = 0;
    arrival.forget();
    for (const int signal : Signals)
        // What nohup, or a shell in the background, has ignored stays so.
        if (std::signal(signal, interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
}

Interruption::~Interruption() {
    for (const int signal : Signals)
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

int Interruption::signal() {
    return came;
}

int Interruption::status(int of_whole_work) {
    return came == 0 ? of_whole_work : 128 + came;
}

} // namespace ffgpu::tools
