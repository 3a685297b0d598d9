// The shared object that the drop-in library loads under `ffgpu run`: a Recording behind
// driver/window_system/recorder.h.

#include "driver/window_system/recorder.h"

#include "driver/window_system/build_id.h"
#include "model/base/input_error.h"
#include "model/timing/machine_stuck.h"
#include "tools/record/recording_arguments.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <semaphore>
#include <thread>

#include <unistd.h>

namespace ffgpu::tools {
namespace {

constexpr int BadInput = 2;
constexpr auto Patience = std::chrono::seconds(2);

volatile std::sig_atomic_t interrupted = 0; // the signal that came
std::binary_semaphore signal_came{0};

// Ctrl-C: the frame that is being drawn is the last. Where the program draws none for a while, or
// waits for events, what is there is completed without it. A second one ends at once.
void interrupt(int signal) {
    if (interrupted) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    interrupted = signal;
    signal_came.release(); // A futex: it may be called here.
}

// Not where the program has a use of its own for the signal.
void catch_signal(int signal) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL)
        std::signal(signal, interrupt);
}

class LiveRecorder final : public gl::Recorder {
public:
    LiveRecorder(const std::string& settings_path, gl::InTurn in_turn)
        : options_(resolved(settings_path))
        , recording_(options_) {
        recording_.before_frame(0);
        catch_signal(SIGINT);
        catch_signal(SIGTERM);
        std::thread([this, in_turn] {
            signal_came.acquire();
            std::this_thread::sleep_for(Patience);
            in_turn([this] { end_by_signal(interrupted); });
        }).detach(); // It and the recorder live as long as the process.
    }

    Device& device() override { return recording_.device(); }

    void frame_shown(const Surface& picture) override {
        if (finished_ || !is_own_process()) return;
        guarded([&] {
            recording_.after_frame({.number = number_, .picture = picture, .api_calls = 0});
            if (interrupted) end_by_signal(interrupted);
            if (number_ == options_.frames.last) end();
            recording_.before_frame(++number_);
        });
    }

    void finish() override {
        if (finished_ || !is_own_process()) return;
        finished_ = true;
        guarded([&] { recording_.finish(); });
        std::fputs(recording_.summary().c_str(), stderr);
    }

private:
    static RecordingOptions resolved(const std::string& path) {
        RecordingOptions options;
        resolve(read_recording_arguments(path), options);
        return options;
    }

    // No exception may pass through the program's frames.
    template <class Call>
    static void guarded(Call&& call) {
        try {
            call();
        } catch (const timing::MachineStuck& stuck) {
            std::fprintf(stderr, "ffgpu: %s\n", stuck.what());
            std::_Exit(timing::StuckStatus);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "ffgpu: %s\n", error.what());
            std::_Exit(BadInput);
        }
    }

    // The last frame of the range is done: nothing more is wanted of the program.
    [[noreturn]] void end() {
        finish();
        std::_Exit(EXIT_SUCCESS);
    }

    void end_by_signal(int signal) {
        finish();
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }

    // A child that the program forked carries a copy of all this, and ends like it: the files are
    // the parent's.
    bool is_own_process() const { return ::getpid() == process_; }

    const pid_t process_ = ::getpid();
    const RecordingOptions options_;
    Recording recording_;
    std::uint64_t number_ = 0;
    bool finished_ = false;
};

} // namespace
} // namespace ffgpu::tools

extern "C" __attribute__((visibility("default"))) ffgpu::gl::Recorder*
ffgpu_open_recorder(const char* settings_path, ffgpu::gl::InTurn in_turn) {
    try {
        return new ffgpu::tools::LiveRecorder(settings_path, in_turn);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ffgpu: %s\n", error.what());
        return nullptr;
    }
}

extern "C" __attribute__((visibility("default"))) const char* ffgpu_recorder_build_id() {
    return ffgpu::gl::build_id();
}
