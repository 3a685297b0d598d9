#include "tools/sweep/sweep_plan.h"

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "model/work/work_file_reader.h"
#include "tools/config/config_file.h"
#include "tools/files/library_folder.h"
#include "tools/report/statistics_file.h"
#include "tools/sweep/text_hash.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

void write_whole(const fs::path& path, const std::string& text) {
    WholeFile file(path.string());
    file.write(text);
    file.commit();
}

// Without comments and empty lines: there may be ten thousand of them.
std::string compact_toml(const Configuration& configuration) {
    std::istringstream lines(to_toml(configuration));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        line.resize(line.find('#') == std::string::npos ? line.size() : line.find('#'));
        line.resize(line.find_last_not_of(' ') + 1);
        if (!line.empty()) text += line + '\n';
    }
    return text;
}

// `build`: a hash of the program, which may be built from other sources than one of its version.
void check_version(const fs::path& plan, const std::string& version, const std::string& build) {
    std::ifstream file(plan);
    if (!file.is_open()) return;
    const Json json = Json::parse(file, nullptr, false);
    const auto has = [&](const char* key, const std::string& text) {
        return !json.is_discarded() && json.contains(key) && json[key] == text;
    };
    if (has("ffgpu", version) && has("build", build)) return;
    throw InputError(fmt::format("{}: the sweep there is another {} of ffgpu, which may "
                                 "count otherwise; give another folder",
                                 plan.parent_path().string(),
                                 has("ffgpu", version) ? "build's" : "version's"));
}

} // namespace

std::string content_hash(const std::string& path, const std::string& choice) {
    std::error_code ignored;
    if (fs::is_other(path, ignored)) // Jobs read it, each from its beginning.
        throw InputError(path + ": is a pipe or a device; a file was expected");
    std::ifstream file(path, std::ios::binary);
    std::array<char, 1 << 16> buffer;
    std::uint64_t hash = hash_on(HashStart, choice);
    while (file.read(buffer.data(), buffer.size()) || file.gcount() > 0)
        hash = hash_on(hash, {buffer.data(), static_cast<std::size_t>(file.gcount())});
    if (!file.is_open() || file.bad()) throw InputError(path + ": cannot be read");
    return fmt::format("{:016x}", hash);
}

bool SweepPlan::needs_values() const {
    return std::any_of(space.points.begin(), space.points.end(), [](const DesignPoint& point) {
        return !point.configuration.timing.needs_values().empty();
    });
}

// A larger space may need values where the work that is there has none.
fs::path SweepPlan::work(const SweepTrace& trace) const {
    if (trace.is_work) return trace.path;
    return folder / "work" / (trace.id + (needs_values() ? ".values.ffw" : ".ffw"));
}

fs::path SweepPlan::point_file(const DesignPoint& point) const {
    return folder / "points" / (point.id + ".toml");
}

fs::path SweepPlan::result(const SweepTrace& trace, const DesignPoint& point) const {
    return folder / "results" / trace.id / (point.id + ".json");
}

std::vector<SweepTrace> sweep_traces(const std::vector<std::string>& paths,
                                     const std::string& frames_text) {
    std::vector<SweepTrace> traces;
    std::set<std::string> names;
    for (const std::string& path : paths) {
        SweepTrace& trace = traces.emplace_back();
        trace.name = fs::path(path).stem().string();
        trace.id = trace.name + '-' + content_hash(path, frames_text);
        trace.path = fs::absolute(path);
        trace.is_work = work::WorkFileReader::is_work_file(path);
        if (trace.is_work) work::WorkFileReader check(path); // its version
        if (trace.is_work && !frames_text.empty())
            throw InputError(path + ": --frames is of traces; a work file is timed whole");
        if (trace.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                         "0123456789_-.") != std::string::npos)
            throw InputError(path + ": the names of a sweep's traces are letters, digits, _ - .");
        if (!names.insert(trace.name).second)
            throw InputError(path + ": another trace of the sweep has this name, which is how the "
                                    "table tells them apart");
    }
    return traces;
}

std::size_t write_plan(const SweepPlan& plan, const std::string& version) {
    const std::string build = content_hash(this_program().string(), version);
    check_version(plan.folder / "plan.json", version, build);
    for (const char* const part : {"work", "points", "results"})
        make_folder((plan.folder / part).string());
    Json json = Json::object();
    json["ffgpu"] = version;
    json["build"] = build;
    json["program"] = this_program().string();
    json["frames"] = plan.frames_text;
    json["values"] = plan.needs_values();
    json["traces"] = Json::object();
    json["missing"] = Json::array();
    for (const DesignPoint& point : plan.space.points)
        if (!fs::exists(plan.point_file(point)))
            write_whole(plan.point_file(point), compact_toml(point.configuration));
    for (const SweepTrace& trace : plan.traces) {
        make_folder((plan.folder / "results" / trace.id).string());
        json["traces"][trace.id] = {{"input", trace.path.string()},
                                    {"is_work", trace.is_work},
                                    {"work", plan.work(trace).string()}};
        for (const DesignPoint& point : plan.space.points)
            if (!fs::exists(plan.result(trace, point)))
                json["missing"].push_back(trace.id + '/' + point.id);
    }
    write_whole(plan.folder / "plan.json", json.dump(1) + '\n');
    return json["missing"].size();
}

} // namespace ffgpu::tools
