#include "driver/window_system/recorder.h"

#include "driver/window_system/build_id.h"
#include "driver/window_system/run_mark.h"
#include "driver/window_system/turn.h"
#include "model/base/float_environment.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <unistd.h>

namespace ffgpu::gl {
namespace {

constexpr int BadInput = 2;

// Why has been said.
[[noreturn]] void end_without_recorder() {
    RunMark::leave_complete();
    std::_Exit(BadInput);
}

[[noreturn]] void fail(const std::string& message) {
    std::fprintf(stderr, "ffgpu: %s\n", message.c_str());
    end_without_recorder();
}

template <class Function>
Function find_function(void* library, const char* name) {
    const auto function = reinterpret_cast<Function>(::dlsym(library, name));
    if (!function) fail(std::string("the recorder is none: ") + ::dlerror());
    return function;
}

Recorder* recorder = nullptr;

void finish_recorder() {
    const FloatEnvironment environment; // It comes at the process's end, in no Turn.
    recorder->finish();
}

void in_turn(const std::function<void()>& call) {
    const Turn turn;
    call();
}

} // namespace

std::unique_ptr<Recorder> open_recorder() {
    const char* const wanted = std::getenv("FFGPU_RECORD");
    if (!wanted || !*wanted) return nullptr;
    const std::string text = wanted;
    // The program's own children would write the same files; those of a run find that it is taken.
    if (!RunMark::is_there()) ::unsetenv("FFGPU_RECORD");
    if (RunMark::is_over()) {
        std::fprintf(stderr,
                     "ffgpu: warning: %s (process %d) draws when the ffgpu that started it has "
                     "ended, and is not recorded\n",
                     ::program_invocation_short_name,
                     static_cast<int>(::getpid()));
        return nullptr;
    }
    if (!RunMark::claim()) {
        std::fprintf(stderr,
                     "ffgpu: warning: %s (process %d) draws too, and is not recorded: another "
                     "process of this run is\n",
                     ::program_invocation_short_name,
                     static_cast<int>(::getpid()));
        return nullptr;
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos)
        fail("FFGPU_RECORD is " + text + ": expected RECORDER.so:SETTINGS.json");
    const std::string path = text.substr(0, colon);
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) fail(std::string("the recorder cannot be loaded: ") + ::dlerror());
    const auto recorder_id = find_function<RecorderBuildId>(library, "ffgpu_recorder_build_id");
    if (std::strcmp(recorder_id(), build_id()) != 0)
        fail(path + " and the library that loads it are of different builds: build both anew");
    const auto open = find_function<OpenRecorder>(library, "ffgpu_open_recorder");
    recorder = open(text.substr(colon + 1).c_str(),
                    {.in_turn = in_turn, .files_complete = RunMark::leave_complete});
    if (!recorder) end_without_recorder();
    std::atexit(finish_recorder);
    std::at_quick_exit(finish_recorder);
    return std::unique_ptr<Recorder>(recorder);
}

} // namespace ffgpu::gl
