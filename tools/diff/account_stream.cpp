#include "tools/diff/account_stream.h"

#include "model/base/check.h"
#include "model/base/input_error.h"
#include "tools/diff/backend.h"
#include "tools/files/other_program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

// The command line that has another build write the account.
std::vector<std::string> arguments_of(const AccountSide& side, const AccountQuestion& question) {
    std::vector<std::string> words{side.program, "diff", side.input, "--account"};
    words.insert(words.end(), {"--backend-a", side.backend});
    words.insert(words.end(), {"--samples", std::to_string(question.samples)});
    words.insert(words.end(),
                 {"--swap", question.swap == gl::SwapMode::Exchange ? "exchange" : "copy"});
    if (question.command) {
        words.insert(words.end(), {"--command", std::to_string(*question.command)});
        words.insert(words.end(), {"--parts", question.parts.to_string()});
    } else {
        std::string frames = std::to_string(question.frames.first) + '-';
        if (question.frames.last < FrameRange{}.last)
            frames += std::to_string(question.frames.last);
        words.insert(words.end(), {"--frames", frames});
    }
    return words;
}

[[noreturn]] void run_program(const std::vector<std::string>& words) {
    become(words);
    fmt::print("{}\nerror\t{}: {}\n", AccountHeader, words[0], std::strerror(errno));
    std::fflush(stdout);
    ::_exit(2);
}

} // namespace

AccountStream::AccountStream(const AccountSide& side, const AccountQuestion& question)
    : side_(side) {
    std::optional<Backend> backend;
    if (!side.stages && side.program.empty()) backend.emplace(side.backend);
    const Stages* const stages = backend ? &backend->stages() : side.stages;
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError("diff: no pipe");
    std::fflush(stdout);
    process_ = ::fork();
    if (process_ < 0) throw InputError("diff: no process");
    if (process_ == 0) {
        std::signal(SIGPIPE, SIG_DFL); // Nobody reads on: it is known enough.
        ::dup2(ends[1], STDOUT_FILENO);
        if (!side.program.empty()) run_program(arguments_of(side, question));
        check(stages != nullptr, "a side that no other program draws is drawn here");
        write_account(side.input, *stages, question, stdout);
        ::_exit(0);
    }
    ::close(ends[1]);
    in_ = ::fdopen(ends[0], "r");
}

AccountStream::~AccountStream() {
    std::fclose(in_);
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::optional<std::string> AccountStream::next_line() {
    if (!begun_ && read_line() != AccountHeader)
        throw InputError(side_.input + ": the account of another version of ffgpu");
    begun_ = true;
    std::string line = read_line();
    if (line == "end") return std::nullopt;
    constexpr std::string_view Error = "error\t";
    if (line.starts_with(Error)) throw InputError(line.substr(Error.size()));
    return line;
}

std::string AccountStream::read_line() {
    std::string line;
    for (int c = getc_unlocked(in_); c != EOF; c = getc_unlocked(in_)) {
        if (c == '\n') return line;
        line += static_cast<char>(c);
    }
    throw InputError(side_.input + ": its account ends early" +
                     (side_.program.empty() ? "" : " (of " + side_.program + ")"));
}

} // namespace ffgpu::tools
