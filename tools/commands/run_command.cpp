#include "driver/window_system/run_mark.h"
#include "model/base/input_error.h"
#include "model/base/no_file_size_signal.h"
#include "tools/commands/commands.h"
#include "tools/commands/unused_reason.h"
#include "tools/commands/warn.h"
#include "tools/files/library_folder.h"
#include "tools/files/other_program.h"
#include "tools/frames/frame_source.h"
#include "tools/record/recording_arguments.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

constexpr int CannotRun = 127; // the shell's status for it

struct Environment {
    std::string name, value;
};

volatile std::sig_atomic_t child = 0;

void pass_on(int signal) {
    const int errno_of_the_interrupted = errno;
    if (child > 0) ::kill(child, signal);
    errno = errno_of_the_interrupted;
}

// The terminal sends Ctrl-C to the program as well; what somebody sent to us alone it has to be
// told. Either way the program decides when it ends, and we wait.
void pass_on_if_sent(int signal, siginfo_t* info, void*) {
    const bool by_a_process = info->si_code <= 0;
    if (by_a_process) pass_on(signal);
}

// Those that end a program wait, from the making of its files to the moment that it can be told.
class HeldSignals {
public:
    HeldSignals() {
        sigset_t ends;
        sigemptyset(&ends);
        for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP})
            sigaddset(&ends, signal);
        ::sigprocmask(SIG_BLOCK, &ends, &before_);
    }
    ~HeldSignals() { release(); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    void release() const { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

void watch_signals() {
    struct sigaction action {};
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    action.sa_sigaction = pass_on_if_sent;
    for (const int signal : {SIGINT, SIGQUIT})
        ::sigaction(signal, &action, nullptr);
    std::signal(SIGTERM, pass_on);
    std::signal(SIGHUP, pass_on);
}

[[noreturn]] void run_child(const std::vector<std::string>& command,
                            const std::vector<Environment>& environment,
                            const HeldSignals& signals) {
    signals.release();
    ::prctl(PR_SET_PDEATHSIG, SIGTERM); // Nobody draws on where ffgpu was killed.
    for (const Environment& variable : environment)
        ::setenv(variable.name.c_str(), variable.value.c_str(), 1);
    become(command);
    const char* const reason = std::strerror(errno);
    std::fprintf(stderr, "ffgpu: %s: cannot be run: %s\n", command[0].c_str(), reason);
    std::_Exit(CannotRun);
}

// Returns its exit status; as the shell, 128 + the number of the signal that ended it. Throws
// InputError if it cannot be started.
int run_program(const std::vector<std::string>& command,
                const std::vector<Environment>& environment,
                const HeldSignals& signals) {
    const pid_t program = ::fork();
    if (program < 0)
        throw InputError("run: no process can be made: " + std::string(std::strerror(errno)));
    if (program == 0) run_child(command, environment, signals);
    child = program;
    watch_signals();
    signals.release();
    int status = 0;
    while (::waitpid(program, &status, 0) < 0 && errno == EINTR) {
    }
    child = 0;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

// TMPDIR may be empty, or name what is not there.
fs::path temporary_folder() {
    std::error_code missing;
    const fs::path folder = fs::temp_directory_path(missing);
    return missing ? fs::path("/tmp") : folder;
}

// A file that lives as long as the program runs. Its lock is held until this process ends, however
// it does: the recorder sees by it that it is alone (tools/recorder/run_watch.h).
class PassingFile {
public:
    explicit PassingFile(const std::string& text) {
        std::string pattern = (temporary_folder() / "ffgpu_run_XXXXXX").string();
        file_ = ::mkostemp(pattern.data(), O_CLOEXEC);
        path_ = pattern;
        if (file_ < 0) fail(errno);
        const NoFileSizeSignal no_signal;
        errno = ENOSPC; // A write that is short by that sets none.
        if (::write(file_, text.data(), text.size()) == static_cast<ssize_t>(text.size())) return;
        const int reason = errno;
        remove();
        fail(reason);
    }
    ~PassingFile() { remove(); }
    PassingFile(const PassingFile&) = delete;
    PassingFile& operator=(const PassingFile&) = delete;

    const std::string& path() const { return path_; }
    void lock() const { ::flock(file_, LOCK_EX); }

private:
    void remove() const {
        ::unlink(path_.c_str());
        ::close(file_);
    }
    [[noreturn]] void fail(int reason) const {
        throw InputError(path_ + ": cannot be written: " + std::strerror(reason));
    }

    std::string path_;
    int file_ = -1;
};

struct Arguments {
    RecordingArguments recording;
    unsigned samples = 1;
    gl::SwapMode swap = gl::SwapMode::Copy;
    std::vector<std::string> command;
};

std::string with_folder_first(const fs::path& folder, const char* paths) {
    return folder.string() + (paths && *paths ? std::string(":") + paths : "");
}

void add_panel(const gl::ControlPanel& panel, std::vector<Environment>& environment) {
    const auto filter = static_cast<std::size_t>(panel.texture_filter);
    if (panel.texture_filter != gl::ForcedFilter::AsAsked)
        environment.push_back({"FFGPU_TEXTURE_FILTER", std::string(gl::ForcedFilterNames[filter])});
    if (panel.supersampling > 1)
        environment.push_back({"FFGPU_SUPERSAMPLING", std::to_string(panel.supersampling)});
}

void warn_of_loss(const std::string& program,
                  const std::string& mark,
                  bool is_recorded,
                  int status) {
    const gl::RunMark::State state = gl::RunMark::read(mark);
    if (!state.draws) warn(unused_reason(program, status));
    if (!state.draws || !is_recorded || state.complete) return;
    if (state.goes_on)
        warn(program +
             " has ended, and what is recorded goes on without it: the files are complete "
             "when it ends");
    else
        warn("what was recorded ended without completing its files (killed, crashed, by _exit, or "
             "it became another program): the last frames' pictures and statistics may be missing, "
             "and a capture or work file keeps its .part name");
}

int run_run(const Arguments& arguments) {
    const fs::path folder = find_library_folder();
    std::vector<Environment> environment{
        {"LD_LIBRARY_PATH", with_folder_first(folder, std::getenv("LD_LIBRARY_PATH"))}};
    if (arguments.samples > 1)
        environment.push_back({"FFGPU_SAMPLES", std::to_string(arguments.samples)});
    if (arguments.swap == gl::SwapMode::Exchange) environment.push_back({"FFGPU_SWAP", "exchange"});
    if (arguments.recording.any()) {
        RecordingOptions checked;
        resolve(arguments.recording, checked); // What is wrong is said before the program starts.
        const gl::ControlPanel panel = checked.configuration.gpu.panel();
        check_samples(arguments.samples, panel);
        add_panel(panel, environment);
        warn_of_settings(settings_without_effect(arguments.recording));
    }
    const HeldSignals signals;
    // The library says here that it was used.
    const PassingFile mark(gl::RunMark::blank());
    environment.push_back({"FFGPU_MARK", mark.path()});
    std::optional<PassingFile> settings;
    if (arguments.recording.any()) {
        settings.emplace(to_json(arguments.recording));
        settings->lock();
        const fs::path recorder = folder / "ffgpu_recorder.so";
        environment.push_back({"FFGPU_RECORD", recorder.string() + ":" + settings->path()});
    }
    const int status = run_program(arguments.command, environment, signals);
    if (status != CannotRun)
        warn_of_loss(arguments.command[0], mark.path(), settings.has_value(), status);
    return status;
}

} // namespace

void add_run_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const verb =
        application.add_subcommand("run", "Runs an OpenGL program, in its window, on ffgpu");
    add_recording_options(*verb, arguments->recording);
    add_samples_option(*verb, arguments->samples);
    add_swap_option(*verb, arguments->swap);
    verb->add_option("program", arguments->command, "The program and its arguments, after --")
        ->required();
    verb->footer("With --frames A-B the program ends after frame B. Exit status: the program's.\n"
                 "Example: ffgpu run -o out --frames 0-99 -- glxgears");
    verb->callback([arguments, &run] { run = [arguments] { return run_run(*arguments); }; });
}

} // namespace ffgpu::tools
