#include "tools/recorder/run_watch.h"

#include "model/base/thread_without_signals.h"

#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace ffgpu::tools {

void on_lost_run(const std::string& settings_path, std::function<void()> lost) {
    const int file = ::open(settings_path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_locked = file >= 0 && ::flock(file, LOCK_SH | LOCK_NB) != 0;
    if (!is_locked) { // The settings are a user's own.
        if (file >= 0) ::close(file);
        return;
    }
    thread_without_signals([file, settings_path, lost = std::move(lost)] {
        while (::flock(file, LOCK_SH) != 0) {
        }
        ::close(file);
        if (::access(settings_path.c_str(), F_OK) == 0) lost();
    }).detach();
}

} // namespace ffgpu::tools
