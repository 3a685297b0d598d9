// `ffgpu run` around programs that do what programs do: fork, never draw, end by signals.

#include "tests/window_system/run_program.h"
#include "tests/window_system/x_server.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;
using namespace tests;

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

// Of each frame's figures in a stats.json the number behind "name": the totals' last.
std::vector<std::string> values_of(const std::string& statistics, const std::string& name) {
    std::vector<std::string> values;
    const std::string key = '"' + name + "\": ";
    for (std::size_t at = statistics.find(key); at != std::string::npos;
         at = statistics.find(key, at + 1)) {
        const std::size_t begin = at + key.size();
        values.push_back(statistics.substr(begin, statistics.find_first_of(",\n}", begin) - begin));
    }
    return values;
}

TEST_CASE("showing pictures is no work of the machine's: a run costs what its capture does") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    fs::create_directories(out.path);
    const std::string capture = (out.path / "all.ffc").string();
    const Outcome run = ffgpu_run("-o " + out.path.string() + " --no-images --timing --capture " +
                                  capture + " -- " FFGPU_FORKS);
    INFO(run.text);
    REQUIRE(run.status == 0);
    const fs::path again = out.path / "again";
    const Outcome replay =
        shell(FFGPU_BINARY " replay " + capture + " --timing --no-images -o " + again.string());
    INFO(replay.text);
    REQUIRE(replay.status == 0);

    const std::string live = statistics_in(out);
    std::ifstream file(again / "stats.json");
    std::stringstream captured;
    captured << file.rdbuf();
    CHECK(count_of(live, "host_read") == count_of(captured.str(), "host_read"));
    const auto cycles = values_of(live, "total_cycles");
    REQUIRE(cycles.size() == 11); // ten frames, and the totals
    CHECK(cycles == values_of(captured.str(), "total_cycles"));
    for (const std::string& bytes : values_of(live, "memory_host_read_bytes"))
        CHECK(bytes == "0");
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

// ThreadSanitizer puts a handler off until a wait in poll() or waitpid() is over, which it never is
// in these two.
#ifndef __SANITIZE_THREAD__
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

TEST_CASE("a second Ctrl-C waits no longer, and loses nothing") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const OutputFolder out;
    const pid_t run = start({"ffgpu", "run", "-o", out.path.string(), "--", FFGPU_FORKS, "wait"});
    REQUIRE(comes_true([&] { return fs::exists(out.path / "frame_0009.png"); }));
    ::kill(-run, SIGINT);
    ::usleep(700'000); // It is not the same one.
    ::kill(-run, SIGINT);
    const int status = wait_status(run);
    CHECK(WEXITSTATUS(status) == 128 + SIGINT);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 10,") == 1);
}

// As `timeout` does it.
TEST_CASE("a signal to ffgpu and its program at once keeps the statistics") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const int signal = GENERATE(SIGTERM, SIGHUP);
    const OutputFolder out;
    const pid_t group = start({"ffgpu", "run", "-o", out.path.string(), "--", FFGPU_FORKS, "wait"});
    CHECK(comes_true([&] { return fs::exists(out.path / "frame_0009.png"); }));
    ::kill(-group, signal);
    const int status = wait_status(group);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + signal);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 10") == 1);
}
#endif

TEST_CASE("Ctrl-C or its terminal's end ends a replay behind a frame, with its statistics") {
    const int signal = GENERATE(SIGINT, SIGHUP);
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
    ::kill(replay, signal);
    ::usleep(20'000); // A key that is pressed twice.
    ::kill(replay, signal);
    const int status = wait_status(replay);
    CHECK(drew);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + signal);
    CHECK(fs::exists(out.path / "stats.json"));
}

// Interrupts it once `begun` is there; its wait status.
int interrupt_once(const std::vector<std::string>& arguments, const fs::path& begun) {
    const pid_t process = start(arguments);
    CHECK(comes_true([&] { return fs::exists(begun); }));
    ::kill(process, SIGINT);
    return wait_status(process);
}

TEST_CASE("Ctrl-C ends time, cache and export behind a frame, and nothing is half written") {
    const OutputFolder out;
    const std::string work = out.path / "corridor.ffw", folder = out.path / "out";
    const std::string trace = FFGPU_SOURCE_DIR "/traces/corridor.trace";
    fs::create_directories(out.path);
    REQUIRE(shell(FFGPU_BINARY " replay " + trace + " --save-work " + work).status == 0);

    const int time =
        interrupt_once({"ffgpu", "time", work, "-o", folder, "--totals", folder + "_"}, folder);
    CHECK(WIFEXITED(time));
    CHECK(WEXITSTATUS(time) == 128 + SIGINT);
    CHECK(count_of(statistics_in({folder}), "\"frame_count\"") == 1);
    CHECK_FALSE(fs::exists(folder + "_")); // They would be of some frames.

    const std::string traffic = out.path / "traffic";
    const fs::path part = traffic + ".part";
    const pid_t process = start({"ffgpu", "export", work, "--format", "perfetto", "-o", traffic});
    CHECK(comes_true([&] { return fs::exists(part.string() + std::to_string(process)); }));
    ::kill(process, SIGINT);
    const int exported = wait_status(process);
    CHECK(WIFEXITED(exported));
    CHECK(WEXITSTATUS(exported) == 128 + SIGINT);
    CHECK_FALSE(fs::exists(part.string() + std::to_string(process)));

    const std::string curves = out.path / "curves";
    const int cache = interrupt_once({"ffgpu", "cache", trace, "-o", curves}, curves);
    CHECK(WIFEXITED(cache));
    CHECK(WEXITSTATUS(cache) == 128 + SIGINT);
}

TEST_CASE("a replay under nohup outlives its terminal") {
    const OutputFolder out;
    const std::string folder = out.path.string();
    const Outcome run = shell("trap '' HUP; " FFGPU_BINARY " replay " FFGPU_SOURCE_DIR
                              "/traces/corridor.trace -o " +
                              folder + " & until [ -e " + folder +
                              "/frame_0000.png ]; do sleep 0.01; done; kill -HUP $!; wait $!");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 8,") == 1);
}

TEST_CASE("a program that never drew on ffgpu is told of") {
    const Outcome run = ffgpu_run("-- /bin/true");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(run.text.find("/bin/true made no OpenGL context on ffgpu") != std::string::npos);
}

TEST_CASE("a program that ends by an error before it draws is told of as one") {
    const Outcome run = ffgpu_run("-- sh -c 'exit 3'");
    INFO(run.text);
    CHECK(run.status == 3);
    CHECK(count_of(run.text,
                   "sh made no OpenGL context on ffgpu: it ended before, with status 3") == 1);
}

TEST_CASE("a program's status is there also where the ends of children are ignored") {
    const Outcome run =
        shell("exec env --ignore-signal=CHLD " FFGPU_BINARY " run -- sh -c 'exit 3'");
    INFO(run.text);
    CHECK(run.status == 3);
}

TEST_CASE("a program that asks for an OpenGL of shaders is told of, once") {
    Display* const display = tests::XServer::display();
    if (!display) return;
    ::setenv("DISPLAY", DisplayString(display), 1);
    const Outcome run = ffgpu_run("-- " FFGPU_FRAMES " later");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(run.text, "frames asks for a context of OpenGL 3.3 and does not get it") == 1);
    CHECK(count_of(run.text, "asks for a context") == 1);
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

// It waits for what its configuration says.
TEST_CASE("a signal before the program is there leaves no file behind") {
    const OutputFolder out;
    fs::create_directories(out.path / "temporary");
    const std::string configuration = out.path / "configuration.toml";
    REQUIRE(::mkfifo(configuration.c_str(), 0600) == 0);
    ::setenv("TMPDIR", (out.path / "temporary").c_str(), 1);
    const pid_t process = start(
        {"ffgpu", "run", "--config", configuration, "-o", out.path / "o", "--", "sleep", "52.25"});
    ::unsetenv("TMPDIR");
    const int file = ::open(configuration.c_str(), O_WRONLY); // when ffgpu reads it
    ::kill(process, SIGTERM);
    const int status = wait_status(process);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGTERM);
    CHECK(fs::is_empty(out.path / "temporary"));
    ::close(file);
}

#ifndef __SANITIZE_THREAD__
TEST_CASE("a signal sent to ffgpu alone reaches the program") {
    const int status = run_and_signal("50.25", SIGINT);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + SIGINT);
}
#endif

TEST_CASE("the program ends where ffgpu was killed") {
    const int status = run_and_signal("51.25", SIGKILL);
    CHECK(WIFSIGNALED(status));
    CHECK(comes_true([] { return shell("pgrep -f '^sleep 51[.]25'").text.empty(); }));
}

} // namespace
} // namespace ffgpu
