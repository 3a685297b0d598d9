// Starting ffgpu as users do, and what came of it.

#pragma once

// clang-format off: before the macros of X.
#include <catch2/catch.hpp>
// clang-format on

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu::tests {

struct Outcome {
    int status = 0;
    std::string text; // of both streams
};

inline Outcome shell(const std::string& command) {
    Outcome outcome;
    std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        outcome.text += static_cast<char>(c);
    const int status = ::pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

inline Outcome ffgpu_run(const std::string& arguments) {
    return shell("timeout 60 " FFGPU_BINARY " run " + arguments);
}

struct OutputFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("ffgpu_run_test_" + std::to_string(::getpid()));
    ~OutputFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

inline std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

// A process of ffgpu that takes signals as one started by a terminal does.
inline pid_t start(std::vector<std::string> arguments) {
    const pid_t process = ::fork();
    if (process != 0) return process;
    std::signal(SIGINT, SIG_DFL);
    ::setpgid(0, 0);
    std::vector<char*> words;
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    ::execv(FFGPU_BINARY, words.data());
    std::_Exit(127);
}

inline int wait_status(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return status;
}

// Whether it came true within a minute: a loaded machine starts programs slowly.
template <class Condition>
bool comes_true(const Condition& condition) {
    for (int tries = 0; tries < 6000; ++tries) {
        if (condition()) return true;
        ::usleep(10'000);
    }
    return false;
}

inline std::string statistics_in(const OutputFolder& folder) {
    std::ifstream file(folder.path / "stats.json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace ffgpu::tests
