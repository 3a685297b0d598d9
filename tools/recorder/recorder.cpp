// The shared object that the drop-in library loads under `ffgpu run`: a Recording behind
// driver/window_system/recorder.h.

#include "driver/window_system/recorder.h"

#include "driver/window_system/build_id.h"
#include "model/base/input_error.h"
#include "model/base/thread_without_signals.h"
#include "model/timing/machine_stuck.h"
#include "tools/commands/warn.h"
#include "tools/record/recording_arguments.h"
#include "tools/recorder/guarded_device.h"
#include "tools/recorder/run_watch.h"
#include "tools/replay/one_signal.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <semaphore>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

constexpr int BadInput = 2;
constexpr auto Patience = std::chrono::seconds(2);

// The signal that came. A handler and a thread write it.
std::atomic<int> interrupted{0};
static_assert(std::atomic<int>::is_always_lock_free);
OneSignal arrival;
std::atomic<bool> is_impatient{false};
std::counting_semaphore<4> signal_came{0};

// Ctrl-C: the frame that is being drawn is the last. Where the program draws none for a while, or
// waits for events, what is there is completed without it. A second one has no patience for that,
// and a third ends at once.
void interrupt(int signal) {
    if (!arrival.is_new()) return;
    if (is_impatient) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    if (interrupted) is_impatient = true;
    interrupted = signal;
    signal_came.release(); // A futex: it may be called here.
}

// Not where the program has a use of its own for the signal.
void catch_signal(int signal) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL)
        std::signal(signal, interrupt);
}

const char* text_of(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) ? OutOfMemory : error.what();
}

class LiveRecorder final : public gl::Recorder {
public:
    LiveRecorder(const std::string& settings_path, const gl::RecorderHost& host)
        : host_(host)
        , options_(resolved(settings_path))
        , recording_(std::in_place, options_)
        , device_(recording_->device(), [this](const InputError& error) { fail(error); }) {
        recording_->before_frame(0);
        thread_without_signals([this] {
            signal_came.acquire();
            static_cast<void>(signal_came.try_acquire_for(Patience));
            host_.in_turn([this] { end_by_signal(interrupted); });
        }).detach(); // It and the recorder live as long as the process.
        on_lost_run(settings_path, [] {
            std::this_thread::sleep_for(Patience); // A signal may come as well: it goes first.
            if (interrupted) return;
            interrupted = SIGTERM;
            signal_came.release();
        });
    }

    Device& device() override { return device_; }

    void frame_shown(const Surface& picture) override {
        if (finished_ || !is_own_process()) {
            tell_of_lost_frame();
            return;
        }
        guarded([&] {
            recording_->after_frame({.number = frames_, .picture = picture, .api_calls = 0});
            const bool is_last = frames_++ == options_.frames.last;
            if (interrupted) end_by_signal(interrupted);
            if (is_last) end();
            recording_->before_frame(frames_);
        });
    }

    void read_picture(DeviceAddress at, std::span<std::byte> bytes) override {
        guarded([&] { recording_->read_picture(at, bytes); });
    }

    void finish() override {
        if (finished_ || !is_own_process()) return;
        finished_ = true;
        guarded([&] { recording_->finish(); });
        host_.files_complete();
        std::fputs(recording_->summary().c_str(), stderr);
        const std::string missing =
            missing_frames(options_.frames, ::program_invocation_short_name, frames_);
        if (!interrupted && !missing.empty()) warn(missing);
    }

private:
    static RecordingOptions resolved(const std::string& path) {
        RecordingOptions options;
        resolve(read_recording_arguments(path), options);
        options.warn = warn;
        return options;
    }

    // No exception may pass through the program's frames.
    template <class Call>
    void guarded(Call&& call) {
        try {
            call();
        } catch (const timing::MachineStuck& stuck) {
            fail(stuck, timing::StuckStatus);
        } catch (const std::exception& error) {
            fail(error);
        }
    }

    // Ends the process; what is done stays as far as it can, and nothing half written does.
    [[noreturn]] void fail(const std::exception& error, int status = BadInput) {
        std::fprintf(stderr, "ffgpu: %s\n", text_of(error));
        try {
            if (!finished_) recording_->finish();
        } catch (const std::exception&) { // The first is what is told.
        }
        host_.files_complete();
        recording_.reset();
        std::_Exit(status);
    }

    // The last frame of the range is done: nothing more is wanted of the program.
    [[noreturn]] void end() {
        finish();
        std::_Exit(EXIT_SUCCESS);
    }

    void end_by_signal(int signal) {
        finish();
        std::signal(signal, SIG_DFL);
        sigset_t own; // A thread of the recorder takes none.
        sigemptyset(&own);
        sigaddset(&own, signal);
        pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
        std::raise(signal);
    }

    // A child that the program forked carries a copy of all this, and ends like it: the files are
    // the parent's.
    bool is_own_process() const { return ::getpid() == process_; }

    // A forked child's first, or the first that an exit handler draws which is older than the
    // recorder: those are called last.
    void tell_of_lost_frame() {
        if (std::exchange(lost_frame_told_, true)) return;
        warn(is_own_process()
                 ? "a frame was drawn when the program had all but ended, and is not recorded"
                 : fmt::format("{} (process {}) draws too, and is not recorded: it was forked by "
                               "the process that is",
                               ::program_invocation_short_name,
                               ::getpid()));
    }

    const pid_t process_ = ::getpid();
    const gl::RecorderHost host_;
    const RecordingOptions options_;
    std::optional<Recording> recording_;
    GuardedDevice device_;
    std::uint64_t frames_ = 0; // so far
    bool finished_ = false;
    bool lost_frame_told_ = false;
};

} // namespace
} // namespace ffgpu::tools

extern "C" __attribute__((visibility("default"))) ffgpu::gl::Recorder*
ffgpu_open_recorder(const char* settings_path, const ffgpu::gl::RecorderHost& host) {
    // Before a file is begun: none is left behind unfinished.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        ffgpu::tools::catch_signal(signal);
    try {
        return new ffgpu::tools::LiveRecorder(settings_path, host);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ffgpu: %s\n", ffgpu::tools::text_of(error));
        return nullptr;
    }
}

extern "C" __attribute__((visibility("default"))) const char* ffgpu_recorder_build_id() {
    return ffgpu::gl::build_id();
}
