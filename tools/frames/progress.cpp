#include "tools/frames/progress.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace ffgpu::tools {
namespace {

constexpr auto Interval = std::chrono::milliseconds(100);
constexpr std::size_t BarWidth = 40;

} // namespace

Progress::Progress(std::optional<std::uint64_t> last)
    : on_terminal_(::isatty(STDERR_FILENO) == 1)
    , last_(last) {}

Progress::~Progress() {
    clear();
}

void Progress::show(std::uint64_t frame) {
    if (!on_terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + Interval;
    std::fputs("\r\033[K", stderr);
    if (last_) {
        const std::size_t full =
            std::min<std::size_t>(BarWidth, BarWidth * (frame + 1) / (*last_ + 1));
        std::fprintf(stderr,
                     "[%s%s] ",
                     std::string(full, '#').c_str(),
                     std::string(BarWidth - full, '.').c_str());
    }
    std::fprintf(stderr, "frame %llu", static_cast<unsigned long long>(frame));
}

void Progress::clear() {
    if (on_terminal_) std::fputs("\r\033[K", stderr);
}

} // namespace ffgpu::tools
