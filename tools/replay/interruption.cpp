#include "tools/replay/interruption.h"

#include <csignal>
#include <initializer_list>

namespace ffgpu::tools {
namespace {

volatile std::sig_atomic_t came = 0;

void interrupt(int signal) {
    came = signal;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interruption::Interruption() {
    came = 0;
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, interrupt);
}

Interruption::~Interruption() {
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, SIG_DFL);
}

int Interruption::signal() {
    return came;
}

} // namespace ffgpu::tools
