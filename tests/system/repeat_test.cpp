// The command line's results again and again: in other processes, and many frames in one.

#include "model/gpu/functional_gpu.h"
#include "model/timing/gpu_timing.h"
#include "model/work/command_assembler.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tools/frames/frame_source.h"
#include "tools/heatmap/heat_recorder.h"
#include "tools/record/work_fan_out.h"
#include "tools/report/statistics_report.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_of(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        files[entry.path().filename().string()] = bytes.str();
    }
    return files;
}

// Frames 0 and 1 with all that replay can write. `environment`: as before a command in a shell.
std::map<std::string, std::string>
replay_in_process(const std::string& environment, const std::string& trace, unsigned threads) {
    const TemporaryFolder folder;
    const std::string command =
        environment + " '" FFGPU_BINARY "' replay '" + trace + "' -o '" + folder.path() +
        "' --frames 0-1 --timing --heatmap overdraw,level,texture_misses,cycles --threads " +
        std::to_string(threads) + " 2>/dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    return files_of(folder.path());
}

TEST_CASE("Another process, other addresses, other garbage in memory: the same files") {
    for (const std::string& name : own_traces()) {
        const std::string trace = own_trace(name);
        const auto first = replay_in_process("", trace, 1);
        REQUIRE(first.size() == 2 * 5 + 2); // five pictures a frame
        CHECK(first.contains("stats.json"));
        CHECK(first.contains("pictures.csv"));
        // The kernel places each process elsewhere; a longer environment moves the stack, and the
        // C library fills what malloc returns and free takes back with other bytes.
        const std::string padding = "FFGPU_TEST_PADDING=" + std::string(4321, 'x');
        for (const auto& environment :
             {padding, std::string("MALLOC_PERTURB_=85"), std::string("MALLOC_PERTURB_=202")}) {
            for (const unsigned threads : {1u, 2u}) {
                const auto again = replay_in_process(environment, trace, threads);
                REQUIRE(again.size() == first.size());
                for (const auto& [file, bytes] : first) {
                    INFO(name << ", " << file << ", " << threads << " threads, "
                              << environment.substr(0, 24));
                    CHECK((again.contains(file) && again.at(file) == bytes));
                }
            }
        }
    }
}

std::uint64_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    REQUIRE(file >> all >> resident);
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

constexpr std::uint64_t Margin = 4 << 20; // What an allocator may keep.

std::uint64_t fragments_written(const Device& gpu) {
    for (const StatisticsGroup* const group : gpu.statistics())
        for (const Counter& counter : group->counters())
            if (counter.name() == "fragments_written") return counter.value();
    return 0;
}

// Draws a trace's last frame again and again.
class Repeater {
public:
    explicit Repeater(const std::string& trace)
        : source_(open_frame_source(
              trace, gpu_, {.warn = [](const std::string&) {}, .keep_last = true})) {
        while (source_->next()) {
        }
    }

    // Returns the resident size afterwards.
    std::uint64_t repeat(unsigned frames) {
        const std::uint64_t written = fragments_written(gpu_);
        for (unsigned i = 0; i < frames; ++i) {
            REQUIRE(source_->repeat_last());
            gpu_.finish();
            heat_.clear();
        }
        REQUIRE(fragments_written(gpu_) - written >= frames * MinimumFragments);
        return resident_bytes();
    }

    // From now on all that can listen does.
    void listen() {
        sinks_.add(assembler_);
        sinks_.add(heat_);
        gpu_.set_work_sink(&sinks_);
    }

private:
    static constexpr std::uint64_t MinimumFragments = 10000; // of a frame of our traces

    FunctionalGpu gpu_{{.threads = 2}};
    timing::GpuTiming timing_{timing::TimingConfig{}};
    work::CommandAssembler assembler_{timing_};
    HeatRecorder heat_;
    WorkFanOut sinks_;
    std::unique_ptr<FrameSource> source_;
};

// The sanitizers keep what was freed for a while, which counts as resident.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("The resident size does not grow with the number of frames") {
    for (const std::string& name : own_traces()) {
        INFO(name);
        Repeater repeater(own_trace(name));
        // The driver writes what it uploads round about: all of that memory has to be in use first.
        const std::uint64_t before = repeater.repeat(600);
        CHECK(repeater.repeat(500) <= before + Margin);
    }
}

TEST_CASE("Nor does it with the timing model and heat maps listening") {
    Repeater repeater(own_trace("chrome"));
    repeater.listen();
    const std::uint64_t before = repeater.repeat(10);
    CHECK(repeater.repeat(40) <= before + Margin);
}

#endif

TEST_CASE("The statistics of many frames wait in a file, and are whole") {
    StatisticsReport report({}, true);
    timing::FrameTiming cycles{.cycles = 5000, .commands = {}};
    for (std::uint32_t draw = 0; draw < 5000; ++draw)
        cycles.commands.push_back({timing::CommandKind::Draw, draw, 1});
    const auto add = [&](std::uint64_t number) {
        report.add({.number = number, .api_calls = 1, .functional = {}},
                   {.counters = {}, .histograms = {}, .frame = cycles});
    };
    add(0);
    const std::uint64_t before = resident_bytes();
    for (std::uint64_t number = 1; number < 50; ++number)
        add(number);
    CHECK(resident_bytes() <= before + Margin);
    std::stringstream text;
    report.write([&text](std::string_view part) { text << part; });
    const auto json = nlohmann::ordered_json::parse(text.str());
    CHECK(json.dump(1) + "\n" == text.str());
    REQUIRE(json["frames"].size() == 50);
    CHECK(json["frame_count"] == 50);
    CHECK(json["frames"][49]["commands"].size() == 5000);
    CHECK(json["totals"]["timing"]["total_cycles"] == 50 * 5000);
}

TEST_CASE("A machine that is gone leaves no memory behind") {
    const auto run = [] {
        return run_trace(own_trace("chrome"),
                         {.threads = 2, .timing = timing::TimingConfig{}, .last_frame = 1})
            .pictures;
    };
    const auto pictures = run();
    run();
    const std::uint64_t before = resident_bytes();
    for (unsigned i = 0; i < 10; ++i)
        CHECK(run() == pictures);
    CHECK(resident_bytes() <= before + Margin);
}

} // namespace
} // namespace ffgpu::tools
