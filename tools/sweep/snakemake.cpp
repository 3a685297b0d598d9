#include "tools/sweep/snakemake.h"

#include "model/base/input_error.h"
#include "tools/files/library_folder.h"
#include "tools/files/other_program.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tools {

namespace fs = std::filesystem;

namespace {

constexpr int NotThere = 127; // as a shell says it
constexpr std::string_view Complaint = "ffgpu: ", Warning = "ffgpu: warning: ";
constexpr std::string_view FullDisk = "No space left on device";
constexpr std::string_view OwnComplaint = "Error: "; // Snakemake's

std::vector<std::string> command_line(const FlowOptions& options) {
    const fs::path flow = find_flow_folder();
    std::vector<std::string> words{"snakemake",
                                   "--snakefile",
                                   flow / "sweep.smk",
                                   "--directory",
                                   options.folder,
                                   "--keep-going",
                                   "--keep-incomplete", // Files come to their names whole.
                                   "--ignore-incomplete",
                                   "--nolock", // The sweep has a lock of its own.
                                   "--rerun-triggers",
                                   "mtime",
                                   "--drop-metadata",
                                   "--nocolor"};
    if (options.profile.empty()) {
        words.insert(words.end(),
                     {"--cores", options.cores == 0 ? "all" : std::to_string(options.cores)});
    } else {
        const fs::path own = flow / options.profile;
        words.insert(
            words.end(),
            {"--profile", fs::exists(own / "config.yaml") ? own.string() : options.profile});
    }
    return words;
}

// Ctrl-C, handed on to Snakemake and its jobs, which have a process group of their own: it is heard
// to its end, and does not write into a pipe that nobody reads, behind which it would wait for ever
// and hold the sweep's lock. One that does not end is killed: what is finished is kept.
class HandedOn {
public:
    explicit HandedOn(pid_t group) {
        group_ = group;
        Action action{};
        action.sa_flags = SA_RESTART;
        action.sa_handler = [](int) {
            came_ = 1;
            ::kill(-group_, SIGINT);
            ::alarm(SecondsToEnd);
        };
        ::sigaction(SIGINT, nullptr, &interrupt_);
        if (interrupt_.sa_handler != SIG_IGN) ::sigaction(SIGINT, &action, nullptr);
        action.sa_handler = [](int) { ::kill(-group_, SIGKILL); };
        ::sigaction(SIGALRM, &action, &alarm_);
    }
    // The process ends as one that does not catch the signal.
    ~HandedOn() {
        ::alarm(0);
        ::sigaction(SIGALRM, &alarm_, nullptr);
        ::sigaction(SIGINT, &interrupt_, nullptr);
        if (came_) ::raise(SIGINT);
    }
    HandedOn(const HandedOn&) = delete;
    HandedOn& operator=(const HandedOn&) = delete;

private:
    static constexpr unsigned SecondsToEnd = 10;

    static inline volatile std::sig_atomic_t group_ = 0, came_ = 0;
    using Action = struct sigaction;
    Action interrupt_{}, alarm_{};
};

[[noreturn]] void run_program(const std::vector<std::string>& words, int output) {
    ::setpgid(0, 0);
    // A sweep that is killed takes Snakemake along. Its handler of SIGTERM may wait for a lock that
    // the thread it runs on holds, for ever, with the sweep's lock.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    become(words);
    ::_exit(NotThere);
}

// What begins behind `key`, if the line has it and nobody said so before.
bool add_new(const std::string& line, std::string_view key, std::vector<std::string>& said) {
    const std::size_t at = line.find(key);
    if (at == std::string::npos) return false;
    const std::string text = line.substr(at + key.size());
    if (std::find(said.begin(), said.end(), text) == said.end()) said.push_back(text);
    return true;
}

class Listener {
public:
    explicit Listener(std::size_t jobs)
        : jobs_(jobs)
        , on_terminal_(::isatty(STDERR_FILENO) == 1) {}
    ~Listener() {
        if (on_terminal_) std::fputs("\r\033[K", stderr);
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    void hear(const std::string& line) {
        if (add_new(line, Warning, said.warnings)) return;
        if (add_new(line, Complaint, said.complaints)) return;
        if (line.find(FullDisk) != std::string::npos)
            full_disk = true; // Snakemake's own
        else if (line.starts_with(OwnComplaint) && own_complaint.empty())
            own_complaint = "Snakemake: " + line.substr(OwnComplaint.size());
        unsigned done = 0, all = 0;
        if (on_terminal_ && std::sscanf(line.c_str(), "%u of %u steps", &done, &all) == 2)
            std::fprintf(stderr, "\r%u of %u jobs, %zu results to make\033[K", done, all, jobs_);
    }

    FlowMessages said;
    std::string own_complaint; // the first
    bool full_disk = false;

private:
    std::size_t jobs_;
    bool on_terminal_;
};

void listen(int input, Listener& listener, const fs::path& log) {
    std::ofstream copy(log);
    std::FILE* const stream = ::fdopen(input, "r");
    std::string line;
    for (int c = std::fgetc(stream); c != EOF; c = std::fgetc(stream)) {
        if (c != '\n') {
            line += static_cast<char>(c);
            continue;
        }
        copy << line << std::endl;
        listener.hear(line);
        line.clear();
    }
    std::fclose(stream);
}

// What jobs elsewhere complained of.
void read_logs(const fs::path& folder, Listener& listener) {
    std::error_code none;
    std::vector<fs::path> logs;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().starts_with("slurm-")) logs.push_back(entry.path());
    std::sort(logs.begin(), logs.end());
    for (const fs::path& path : logs) {
        std::ifstream log(path);
        for (std::string line; std::getline(log, line);)
            listener.hear(line);
    }
}

} // namespace

fs::path find_flow_folder() {
    const fs::path above = this_program().parent_path().parent_path();
    for (const char* const place : {FFGPU_INSTALLED_FLOW, FFGPU_BUILT_FLOW})
        if (fs::exists(above / place / "sweep.smk")) return above / place;
    throw InputError("sweep: ffgpu's sweep.smk is neither in " +
                     (above / FFGPU_INSTALLED_FLOW).string() + " nor in " +
                     (above / FFGPU_BUILT_FLOW).string());
}

FlowMessages run_flow(const FlowOptions& options) {
    const std::vector<std::string> words = command_line(options);
    const fs::path logs = options.folder / "log";
    std::error_code ignored;
    fs::remove_all(logs, ignored); // of the run before
    fs::create_directories(logs, ignored);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw InputError(std::string("sweep: no pipe: ") + std::strerror(errno));
    const pid_t child = ::fork();
    if (child < 0) throw InputError(std::string("sweep: no process: ") + std::strerror(errno));
    if (child == 0) run_program(words, ends[1]);
    ::setpgid(child, child); // Whoever comes first.
    ::close(ends[1]);
    const HandedOn handed_on(child);
    Listener listener(options.jobs);
    listen(ends[0], listener, logs / "snakemake.txt");
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == NotThere)
        throw InputError("sweep: snakemake is not installed (Debian: apt install snakemake)");
    if (!options.profile.empty()) read_logs(logs, listener);
    std::vector<std::string>& complaints = listener.said.complaints;
    if (listener.full_disk && complaints.empty())
        complaints.push_back(fmt::format("{}: {}", options.folder.string(), FullDisk));
    if (!listener.own_complaint.empty() && complaints.empty())
        complaints.push_back(listener.own_complaint);
    if (WIFSIGNALED(status) && complaints.empty())
        complaints.push_back(fmt::format("Snakemake was ended by signal {}", WTERMSIG(status)));
    return listener.said;
}

} // namespace ffgpu::tools
