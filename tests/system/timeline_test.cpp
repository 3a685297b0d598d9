// Timelines of the machine: what they show of each unit, summed up again, is the unit's account.

#include "model/timing/memory_request.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tests/tools/tool.h"
#include "tools/export/export.h"

#include <array>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#ifdef FFGPU_WITH_FST
#include <fstapi.h>
#endif

namespace ffgpu::tools {
namespace {

constexpr std::array<const char*, 5> Activities{
    "busy", "idle", "stalled_output", "stalled_memory", "stalled_requests"};

// Of a unit and an activity, like raster_busy.
using Cycles = std::map<std::string, std::uint64_t>;

struct Machine {
    std::string trace = own_trace("chrome");
    timing::TimingConfig config;
    Run run = run_trace(trace, {.timing = config, .last_frame = 0});
    std::uint64_t cycles = run.cycles.at(0);
};

const Machine& machine() {
    static const Machine only;
    return only;
}

void export_to(const std::string& path, ExportFormat format) {
    export_trace({.input = machine().trace, .output = path, .format = format, .frames = {0, 0}});
}

// Units as the accounts name them.
std::vector<std::string> units() {
    std::vector<std::string> names;
    for (const auto& [counter, value] : machine().run.timed) {
        const std::size_t end = counter.rfind("_idle_cycles");
        if (end != std::string::npos) names.push_back(counter.substr(0, end));
    }
    return names;
}

void check_accounts(const Cycles& cycles, bool with_idle) {
    REQUIRE(units().size() > 10);
    for (const std::string& unit : units())
        for (const char* const activity : Activities) {
            if (!with_idle && activity == std::string("idle")) continue;
            const std::string name = unit + '_' + activity;
            INFO(name);
            const auto found = cycles.find(name);
            CHECK((found == cycles.end() ? 0 : found->second) ==
                  machine().run.timed.at(name + "_cycles"));
        }
}

// What a variable was, as changes of it come.
class Durations {
public:
    void change(const std::string& unit, unsigned activity, std::uint64_t time) {
        end(unit, time);
        now_[unit] = {activity, time};
    }
    Cycles total(std::uint64_t time) {
        for (const auto& [unit, state] : std::map(now_))
            end(unit, time);
        return sums_;
    }

private:
    void end(const std::string& unit, std::uint64_t time) {
        const auto found = now_.find(unit);
        if (found == now_.end()) return;
        sums_[unit + '_' + Activities.at(found->second.first)] += time - found->second.second;
        found->second.second = time;
    }

    std::map<std::string, std::pair<unsigned, std::uint64_t>> now_;
    Cycles sums_;
};

// A counter over time: what it was, times the cycles.
struct Level {
    std::uint64_t since = 0;
    double value = 0, sum = 0;

    void change(std::uint64_t time, double next) {
        sum += value * static_cast<double>(time - since);
        since = time;
        value = next;
    }
};

TEST_CASE("the vectors of a VCD, summed up, are the accounts", "[export]") {
    const TemporaryFile file("", ".vcd");
    export_to(file.path(), ExportFormat::Vcd);
    std::istringstream text(content(file.path()));
    std::map<std::string, std::string> names; // by code
    std::string module;
    Durations durations;
    std::uint64_t time = 0;
    for (std::string word; text >> word;) {
        if (word == "$comment") {
            while (word != "$end")
                text >> word;
        }
        if (word == "$scope") text >> word >> module;
        if (word == "$var") {
            std::string type, code;
            unsigned bits = 0;
            text >> type >> bits >> code >> word;
            CHECK((type == "wire" && bits == 3 && word == "activity"));
            names[code] = module;
        }
        if (word[0] == '#') {
            const std::uint64_t next = std::stoull(word.substr(1));
            CHECK((next > time || next == 0));
            time = next;
        }
        if (word[0] == 'b') {
            std::string code;
            text >> code;
            durations.change(names.at(code),
                             static_cast<unsigned>(std::stoul(word.substr(1), nullptr, 2)),
                             time);
        }
    }
    CHECK(names.size() == units().size());
    CHECK(time == machine().cycles);
    check_accounts(durations.total(time), true);
}

TEST_CASE("the spans and counters of Perfetto, summed up, are the accounts", "[export]") {
    const TemporaryFile file("", ".json");
    export_to(file.path(), ExportFormat::Perfetto);
    const nlohmann::json trace = nlohmann::json::parse(content(file.path()));
    std::map<std::pair<int, int>, std::string> tracks;
    std::map<std::pair<int, int>, std::uint64_t> ends;
    Cycles spans, sums, bytes;
    std::map<std::string, Level> queues;
    for (const auto& event : trace.at("traceEvents")) {
        const std::pair<int, int> track{event.at("pid"), event.at("tid")};
        const std::string kind = event.at("ph"), name = event.at("name");
        if (name == "thread_name") tracks[track] = event.at("args").at("name");
        if (kind == "X") {
            const std::uint64_t begin = event.at("ts"), duration = event.at("dur");
            CHECK(begin >= ends[track]); // Spans of a track lie one behind the other.
            ends[track] = begin + duration;
            spans[tracks.at(track) + '_' + name] += duration;
            sums[tracks.at(track)] += duration;
        }
        if (kind == "C" && event.at("args").contains("items")) {
            queues[name].change(event.at("ts"), event.at("args").at("items"));
            continue;
        }
        if (kind == "C")
            for (const auto& [client, value] : event.at("args").items())
                bytes[client] += value.get<std::uint64_t>();
    }
    check_accounts(spans, false);
    CHECK(sums.at("commands") == machine().cycles);
    CHECK(sums.at("frames") == machine().cycles);
    // Means have three digits, which are all of a thousandth part of an interval of 1,000 cycles;
    // the last interval is shorter.
    unsigned with_items = 0;
    for (const auto& [counter, value] : machine().run.timed) {
        if (!counter.starts_with("queue_") || !counter.ends_with("_item_cycles")) continue;
        INFO(counter);
        Level& level = queues[counter.substr(6, counter.size() - 6 - 12)];
        level.change(machine().cycles, 0);
        CHECK(level.sum == Approx(static_cast<double>(value)).margin(0.5));
        with_items += value > 0;
    }
    CHECK(with_items > 10);
    CHECK(bytes.size() == timing::Clients);
    for (const auto& [client, value] : bytes) {
        INFO(client);
        CHECK(value == machine().run.timed.at("memory_" + client + "_read_bytes") +
                           machine().run.timed.at("memory_" + client + "_written_bytes"));
    }
}

#ifdef FFGPU_WITH_FST
TEST_CASE("the variables of an FST, as GTKWave reads them, are the accounts", "[export]") {
    const TemporaryFile file("", ".fst");
    export_to(file.path(), ExportFormat::Fst);
    void* const reader = fstReaderOpen(file.path().c_str());
    REQUIRE(reader != nullptr);
    struct Reading {
        std::map<fstHandle, std::string> names;
        Durations durations;
    } reading;
    std::string module;
    while (const fstHier* const item = fstReaderIterateHier(reader)) {
        if (item->htyp == FST_HT_SCOPE) module = item->u.scope.name;
        if (item->htyp == FST_HT_VAR) reading.names[item->u.var.handle] = module;
    }
    fstReaderSetFacProcessMaskAll(reader);
    fstReaderIterBlocks(
        reader,
        [](void* user, std::uint64_t time, fstHandle variable, const unsigned char* value) {
            auto& to = *static_cast<Reading*>(user);
            to.durations.change(
                to.names.at(variable),
                static_cast<unsigned>(std::stoul(reinterpret_cast<const char*>(value), nullptr, 2)),
                time);
        },
        &reading,
        nullptr);
    CHECK(fstReaderGetEndTime(reader) == machine().cycles);
    CHECK(reading.names.size() == units().size());
    fstReaderClose(reader);
    check_accounts(reading.durations.total(machine().cycles), true);
}

TEST_CASE("equal work gives an equal FST", "[export]") {
    const TemporaryFile a("", ".fst"), b("", ".fst");
    export_to(a.path(), ExportFormat::Fst);
    export_to(b.path(), ExportFormat::Fst);
    CHECK(content(a.path()) == content(b.path()));
    CHECK(content(a.path()).size() > 1000);
}

TEST_CASE("an FST goes to no pipe, device or folder, which stay what they are", "[export]") {
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe", link = folder / "link.fst";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::filesystem::create_symlink(pipe, link);
    for (const std::string& output : {pipe, link, folder.path()}) {
        INFO(output);
        int status = 0;
        // No input is there: the output is looked at first.
        const std::string line = printed(stderr, [&] {
            status = run({"export", folder / "none.trace", "--format", "fst", "-o", output});
        });
        CHECK(status == 2);
        const bool is_folder = output == folder.path();
        CHECK(line == (is_folder ? "ffgpu: -o " + output + ": is a folder; a file was expected\n"
                                 : "ffgpu: " + output +
                                       ": is no regular file, as --format fst needs: it is not "
                                       "written in order\n"));
    }
    CHECK(std::filesystem::is_fifo(pipe));
    CHECK(std::filesystem::is_symlink(link));
    const std::filesystem::directory_iterator files(folder.path());
    CHECK(std::distance(begin(files), end(files)) == 2);
}
#endif

} // namespace
} // namespace ffgpu::tools
