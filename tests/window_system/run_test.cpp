// `ffgpu run` around programs that do what programs do: fork, never draw, end by signals.

#include "tests/window_system/x_server.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int status = 0;
    std::string text; // of both streams
};

Outcome shell(const std::string& command) {
    Outcome outcome;
    std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        outcome.text += static_cast<char>(c);
    const int status = ::pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

Outcome ffgpu_run(const std::string& arguments) {
    return shell("timeout 60 " FFGPU_BINARY " run " + arguments);
}

struct OutputFolder {
    fs::path path = fs::temp_directory_path() / ("ffgpu_run_test_" + std::to_string(::getpid()));
    ~OutputFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

std::size_t count_of(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

// A process of ffgpu that takes signals as one started by a terminal does.
pid_t start(std::vector<std::string> arguments) {
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

int wait_status(pid_t process) {
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

TEST_CASE("children that a recorded program forks leave its files alone") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    const std::string capture = (out.path / "all.ffc").string();
    fs::create_directories(out.path);
    const Outcome run =
        ffgpu_run("-o " + out.path.string() + " --capture " + capture + " -- " FFGPU_FORKS);
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(run.text, "10 frames") == 1); // Nobody but the program itself sums up.

    std::ifstream file(out.path / "stats.json");
    std::stringstream text;
    text << file.rdbuf();
    CHECK(count_of(text.str(), "\"frame_count\": 10") == 1);
    CHECK(count_of(text.str(), "\"api_calls\"") == 11); // ten frames, and the totals

    const fs::path again = out.path / "again";
    const Outcome replay =
        shell(FFGPU_BINARY " replay " + capture + " --no-images -o " + again.string());
    INFO(replay.text);
    CHECK(replay.status == 0);
}

std::string statistics_in(const OutputFolder& folder) {
    std::ifstream file(folder.path / "stats.json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST_CASE("of two programs that draw at the same time one is recorded, the other named") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FORKS " exec");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(run.text, "10 frames") == 1);
    CHECK(count_of(run.text, "frames,") == 1);
    CHECK(count_of(run.text, "draws too, and is not recorded") == 1);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 10") == 1);
}

TEST_CASE("programs one after the other: the first with a frame is recorded") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() +
                                  " -- sh -c '" FFGPU_FORKS " child; " FFGPU_FORKS "' < /dev/null");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 1,") == 1);
    CHECK(count_of(run.text, "draws too, and is not recorded") == 1);
}

TEST_CASE("Ctrl-C while the program waits for events keeps its statistics") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    const Outcome run = shell("timeout --foreground -s INT 2 " FFGPU_BINARY " run -o " +
                              out.path.string() + " -- " FFGPU_FORKS " wait");
    INFO(run.text);
    CHECK(count_of(run.text, "10 frames") == 1);
    std::ifstream file(out.path / "stats.json");
    std::stringstream text;
    text << file.rdbuf();
    CHECK(count_of(text.str(), "\"frame_count\": 10") == 1);
}

TEST_CASE("Ctrl-C ends a replay behind a frame, with its statistics") {
    const OutputFolder out;
    const pid_t replay = start({"ffgpu",
                                "replay",
                                std::string(FFGPU_SOURCE_DIR) + "/traces/corridor.trace",
                                "--reference",
                                "--timing",
                                "--samples",
                                "4",
                                "-o",
                                out.path.string()});
    const bool drew = comes_true([&] { return fs::exists(out.path / "frame_0000.png"); });
    ::kill(replay, SIGINT);
    const int status = wait_status(replay);
    CHECK(drew);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + SIGINT);
    CHECK(fs::exists(out.path / "stats.json"));
}

TEST_CASE("a program that never drew on ffgpu is told of") {
    const Outcome run = ffgpu_run("-- /bin/true");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(run.text.find("/bin/true made no OpenGL context on ffgpu") != std::string::npos);
}

TEST_CASE("a recorder of another build than the library that loads it is refused") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const Outcome run = shell("timeout 60 env LD_LIBRARY_PATH=" FFGPU_LIBRARY_FOLDER
                              " FFGPU_RECORD=" FFGPU_STALE_RECORDER ":none " FFGPU_FORKS);
    INFO(run.text);
    CHECK(run.status == 2);
    CHECK(count_of(run.text, FFGPU_STALE_RECORDER) == 1);
    CHECK(count_of(run.text, "of different builds") == 1);
}

// `ffgpu run -- sleep SECONDS`, which gets `signal` once the program is there; its wait status.
int run_and_signal(const std::string& seconds, int signal) {
    const pid_t process = start({"ffgpu", "run", "--", "sleep", seconds});
    const std::string program = "pgrep -f '^sleep " + seconds + "'";
    const bool runs = comes_true([&] { return !shell(program).text.empty(); });
    ::kill(process, signal);
    const int status = wait_status(process);
    CHECK(runs);
    return status;
}

TEST_CASE("a signal sent to ffgpu alone reaches the program") {
    const int status = run_and_signal("50.25", SIGINT);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + SIGINT);
}

TEST_CASE("the program ends where ffgpu was killed") {
    const int status = run_and_signal("51.25", SIGKILL);
    CHECK(WIFSIGNALED(status));
    CHECK(comes_true([] { return shell("pgrep -f '^sleep 51[.]25'").text.empty(); }));
}

} // namespace
} // namespace ffgpu
