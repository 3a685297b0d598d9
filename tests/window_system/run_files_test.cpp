// The files of `ffgpu run`, whatever becomes of the program, of ffgpu, or of the disk.

#include "tests/window_system/run_program.h"
#include "tests/window_system/x_server.h"

#include <filesystem>
#include <string>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;
using namespace tests;

bool has_display() {
    Display* const display = XServer::display();
    if (display) ::setenv("DISPLAY", DisplayString(display), 1);
    return display != nullptr;
}

std::size_t files_in(const fs::path& folder) {
    std::error_code missing;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder, missing), fs::directory_iterator()));
}

constexpr const char* NotComplete = "what was recorded ended without completing its files";

TEST_CASE("children that end while a picture is written leave it whole") {
    if (!has_display()) return;
    const OutputFolder out;
    const std::string folder = out.path.string();
    const Outcome run = ffgpu_run("-o " + folder + " -- " FFGPU_FRAMES " noise");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(files_in(out.path) == 42); // with stats.json and pictures.csv
    const Outcome compare = shell(FFGPU_BINARY " compare " + folder + " " + folder);
    INFO(compare.text);
    CHECK(compare.status == 0); // Each can be read.
}

TEST_CASE("a program that is killed leaves statistics that are a second old at most") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " killed");
    INFO(run.text);
    CHECK(run.status == 128 + SIGKILL);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 11,") == 1);
    CHECK(count_of(run.text, NotComplete) == 1);
}

TEST_CASE("a program that leaves by _exit or becomes another is told of") {
    if (!has_display()) return;
    const auto run = [](const std::string& mode) {
        const OutputFolder out;
        Outcome outcome = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " " + mode);
        CHECK(outcome.status == 4);
        return outcome.text;
    };
    CHECK(count_of(run("abandon"), NotComplete) == 1);
    const std::string become = run("become");
    INFO(become);
    CHECK(count_of(become, NotComplete) == 1);
    CHECK(count_of(become, "draws too, and is not recorded") == 1);
    CHECK(count_of(ffgpu_run("-- " FFGPU_FRAMES " abandon").text, "warning") == 0);
}

TEST_CASE("what an exit handler draws is drawn and recorded") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " last");
    INFO(run.text);
    CHECK(run.status == 0);
    const std::string frame = (out.path / "frame_000").string();
    // Red from 0 to 255, and the root of a third of its square.
    CHECK(count_of(shell(FFGPU_BINARY " compare " + frame + "0.png " + frame + "1.png").text,
                   "147.22") == 1);
}

TEST_CASE("what an exit handler draws behind the recorder's is told of") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " early");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(files_in(out.path) == 3); // with stats.json and pictures.csv
    CHECK(count_of(run.text, "when the program had all but ended, and is not recorded") == 1);
}

TEST_CASE("a child that draws on without the recorded process is told of") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " daemon");
    INFO(run.text);
    CHECK(run.status == 4);
    CHECK(count_of(run.text, "draws too, and is not recorded: it was forked") == 1);
    CHECK(count_of(run.text, NotComplete) == 1); // It does not say that they will be.
}

TEST_CASE("quick_exit completes the files") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " quick");
    INFO(run.text);
    CHECK(run.status == 5);
    CHECK(files_in(out.path) == 5);
    CHECK(count_of(statistics_in(out), "\"frame_count\": 3,") == 1);
}

TEST_CASE("a TMPDIR that is empty or not there is none") {
    if (!has_display()) return;
    for (const std::string folder : {"", "/nonexistent"}) {
        const OutputFolder out;
        const Outcome run = shell("TMPDIR=" + folder + " " FFGPU_BINARY " run -o " +
                                  out.path.string() + " -- " FFGPU_FRAMES " last");
        INFO(run.text);
        CHECK(run.status == 0);
        CHECK(files_in(out.path) == 4);
    }
}

TEST_CASE("a program that leaves no memory is one line and status 2") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run = ffgpu_run("-o " + out.path.string() + " -- " FFGPU_FRAMES " starved");
    CHECK(run.status == 2);
    CHECK(run.text.rfind("ffgpu: out of memory", 0) == 0);
    CHECK(count_of(run.text, "\n") == 1);
}

TEST_CASE("a program that its script leaves behind is told of, and completes its files") {
    if (!has_display()) return;
    const OutputFolder out;
    const std::string folder = out.path.string();
    const Outcome run =
        ffgpu_run("-o " + folder + " -- sh -c 'timeout 4 " FFGPU_FRAMES " endless & until [ -e " +
                  folder + "/frame_0003.png ]; do sleep 0.05; done'");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(run.text, "what is recorded goes on without it") == 1);
    CHECK(count_of(run.text, " frames, ") == 1); // its own summary, when it was ended
    CHECK(count_of(statistics_in(out), "\"frame_count\"") == 1);
}

TEST_CASE("a program that draws when ffgpu has ended draws, and tells why nothing is recorded") {
    if (!has_display()) return;
    const OutputFolder out;
    const Outcome run =
        ffgpu_run("-o " + out.path.string() + " -- sh -c '(sleep 1; " FFGPU_FORKS ") & exit 0'");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(count_of(run.text, "sh made no OpenGL context on ffgpu") == 1);
    CHECK(count_of(run.text, "when the ffgpu that started it has ended") == 1);
    CHECK(files_in(out.path) == 0);
}

TEST_CASE("a program that a script has started ends where ffgpu was killed") {
    if (!has_display()) return;
    const OutputFolder out;
    const std::string script = FFGPU_FRAMES " endless; exit 3";
    const pid_t process =
        start({"ffgpu", "run", "-o", out.path.string(), "--", "sh", "-c", script});
    CHECK(comes_true([&] { return fs::exists(out.path / "frame_0009.png"); }));
    const std::string program = "pgrep -f '^" FFGPU_FRAMES " endless'";
    CHECK_FALSE(shell(program).text.empty());
    ::kill(process, SIGKILL);
    wait_status(process);
    CHECK(comes_true([&] { return shell(program).text.empty(); }));
    CHECK(count_of(statistics_in(out), "\"frame_count\"") == 1);
}

TEST_CASE("a file that finds no room ends the run with its name and status 2") {
    if (!has_display()) return;
    const OutputFolder out;
    fs::create_directories(out.path);
    const auto limited = [&](const std::string& arguments) { // 8 blocks of 512 bytes
        return shell("ulimit -f 8; timeout 60 " FFGPU_BINARY " run " + arguments +
                     " -- " FFGPU_FRAMES " noise");
    };
    const Outcome pictures = limited("-o " + out.path.string());
    INFO(pictures.text);
    CHECK(pictures.status == 2);
    CHECK(count_of(pictures.text, "frame_0000.png: cannot be written: File too large") == 1);
    CHECK(files_in(out.path) <= 2); // at most stats.json and pictures.csv
    const Outcome capture = limited("--capture " + (out.path / "c.ffc").string());
    INFO(capture.text);
    CHECK(capture.status == 2);
    CHECK(count_of(capture.text, "c.ffc: cannot be written: File too large") == 1);
    CHECK(files_in(out.path) <= 2);
}

// Its own files, which tell the program's processes of each other.
TEST_CASE("a temporary folder without room ends the run with one line, and is left as it was") {
    const OutputFolder out;
    fs::create_directories(out.path);
    const Outcome run =
        shell("ulimit -f 0; TMPDIR=" + out.path.string() + " " FFGPU_BINARY " run -- true");
    INFO(run.text);
    CHECK(run.status == 2);
    CHECK(count_of(run.text, "cannot be written: File too large") == 1);
    CHECK(files_in(out.path) == 0);
}

TEST_CASE("what a program's processes tell a run wants no room that a full disk has not") {
    const Outcome room = ffgpu_run("-- sh -c 'wc -c < $FFGPU_MARK'");
    CHECK(room.text.rfind("4\n", 0) == 0); // All bytes that are ever written.
}

TEST_CASE("a folder whose name is no UTF-8 gets a run's files") {
    if (!has_display()) return;
    const OutputFolder out;
    const fs::path odd = out.path / "\xff\xe9";
    const Outcome run = ffgpu_run("-o '" + odd.string() + "' -- " FFGPU_FRAMES " last");
    INFO(run.text);
    CHECK(run.status == 0);
    CHECK(files_in(odd) == 4);
}

TEST_CASE("no file takes the place of a standard stream that is closed") {
    const OutputFolder out;
    const Outcome run =
        shell("(" FFGPU_BINARY " replay " FFGPU_SOURCE_DIR
              "/traces/corridor.trace --reference --timing -o " +
              out.path.string() + " <&- >&- 2>&- & until [ -e " + out.path.string() +
              "/frame_0000.png ]; do sleep 0.01; done; readlink /proc/$!/fd/[012]; kill $!)");
    CHECK(run.text == "/dev/null\n/dev/null\n/dev/null\n");
}

TEST_CASE("a folder that cannot be made ends the run with its name, and nothing else is told") {
    if (!has_display()) return;
    const Outcome run = ffgpu_run("-o /proc/none -- " FFGPU_FORKS);
    INFO(run.text);
    CHECK(run.status == 2);
    CHECK(count_of(run.text, "/proc/none: cannot be made: No such file or directory") == 1);
    CHECK(count_of(run.text, "\n") == 1);
}

TEST_CASE("frames that a program never draws are told of, and pictures of an older run") {
    if (!has_display()) return;
    const OutputFolder out;
    const auto run = [&](const std::string& frames) {
        const Outcome outcome =
            ffgpu_run("-o " + out.path.string() + " --frames " + frames + " -- " FFGPU_FORKS);
        CHECK(outcome.status == 0);
        return outcome.text;
    };
    CHECK(count_of(run("0-9"), "warning") == 0);
    const std::string short_of = run("4-200");
    CHECK(count_of(short_of, "ends before frame 10, 200 was asked for") == 1);
    CHECK(count_of(short_of, "holds 4 pictures of an older run") == 1);
    CHECK(count_of(run("100-"), "ends before frame 10: none of those asked for is there") == 1);
}

} // namespace
} // namespace ffgpu
