// OneSignal: signals that come close together are one. Who signals a group of processes reaches a
// program once himself and once by way of ffgpu; a key that is pressed in anger is pressed twice.

#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>

namespace ffgpu::tools {

class OneSignal {
public:
    // Of a handler: whether the signal that has come is another than the one before.
    bool is_new() noexcept {
        struct timespec now {};
        ::clock_gettime(CLOCK_MONOTONIC, &now);
        const std::int64_t milliseconds = std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
        if (milliseconds - at_ < Milliseconds) return false;
        at_ = milliseconds;
        return true;
    }

    void forget() noexcept { at_ = -Milliseconds; }

private:
    static constexpr std::int64_t Milliseconds = 500;
    static_assert(std::atomic<std::int64_t>::is_always_lock_free);
    std::atomic<std::int64_t> at_{-Milliseconds};
};

} // namespace ffgpu::tools
