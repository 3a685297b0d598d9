#include "tools/check/suite.h"

#include "model/base/input_error.h"
#include "model/device/layout/limits.h"
#include "tools/config/nearest_name.h"
#include "tools/config/toml_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> SuiteKeys{"name", "max_rmse", "max_worst", "trace"};
const std::vector<std::string> TraceKeys{
    "name", "input", "reference", "frames", "max_rmse", "max_worst", "samples"};

// A table of the file, whose keys are known and whose values have the type that is asked for.
class Table {
public:
    Table(const toml::table& table, std::string path)
        : table_(table)
        , path_(std::move(path)) {}

    void expect_keys(const std::vector<std::string>& known) const {
        for (const auto& entry : table_) {
            const std::string key(entry.first.str());
            if (std::find(known.begin(), known.end(), key) == known.end())
                fail(
                    entry.second,
                    fmt::format("unknown key {}; did you mean {}?", key, nearest_name(key, known)));
        }
    }

    std::optional<std::string> text(const char* key) const {
        return value<std::string>(key, "a text in quotes");
    }
    std::optional<double> number(const char* key) const {
        const auto number = value<double>(key, "a number");
        if (number && !(*number >= 0))
            fail(*table_.get(key), key + std::string(": expected a number not below 0"));
        return number;
    }

    [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
        throw InputError(place(node) + ": " + what);
    }
    std::string place(const toml::node& node) const {
        return fmt::format("{}:{}", path_, node.source().begin.line);
    }
    const toml::table& node() const { return table_; }

private:
    template <class Value>
    std::optional<Value> value(const char* key, const char* expected) const {
        const toml::node* const node = table_.get(key);
        if (!node) return std::nullopt;
        auto found = node->value<Value>();
        if (!found) fail(*node, fmt::format("{}: expected {}", key, expected));
        return found;
    }

    const toml::table& table_;
    const std::string path_;
};

Tolerance tolerance_in(const Table& table, Tolerance tolerance) {
    tolerance.max_rmse = table.number("max_rmse").value_or(tolerance.max_rmse);
    if (const auto worst = table.number("max_worst"))
        tolerance.max_worst = static_cast<unsigned>(std::min(*worst, 255.0));
    return tolerance;
}

SuiteTrace read_trace(const Table& table, const fs::path& folder, const Tolerance& usual) {
    table.expect_keys(TraceKeys);
    const auto needed = [&](const char* key) {
        const auto text = table.text(key);
        if (!text) table.fail(table.node(), fmt::format("a trace needs {}", key));
        return *text;
    };
    SuiteTrace trace;
    const fs::path input = needed("input");
    trace.input = (folder / input).lexically_normal().string();
    trace.reference = (folder / needed("reference")).lexically_normal().string();
    trace.name = table.text("name").value_or(input.stem().string());
    if (trace.name.empty() || trace.name[0] == '.' || trace.name.find('/') != std::string::npos)
        table.fail(table.node(), fmt::format("name {}: is not one of a folder", trace.name));
    if (const auto frames = table.text("frames"))
        trace.frames =
            parse_frame_range(*frames, table.place(*table.node().get("frames")) + ": frames");
    trace.tolerance = tolerance_in(table, usual);
    const double samples = table.number("samples").value_or(1);
    if (samples != 1 && samples != MaxSamples)
        table.fail(table.node(), fmt::format("samples: expected 1 or {}", MaxSamples));
    trace.samples = static_cast<unsigned>(samples);
    return trace;
}

} // namespace

Suite read_suite(const std::string& path) {
    const toml::table file = read_toml_file(path);
    const Table table(file, path);
    table.expect_keys(SuiteKeys);
    Suite suite{.name = table.text("name").value_or(fs::path(path).stem().string()), .traces = {}};
    const Tolerance usual = tolerance_in(table, {});
    const toml::array* const traces = file.get_as<toml::array>("trace");
    if (!traces || traces->empty())
        throw InputError(path + ": expected a [[trace]] with input and reference");
    std::set<std::string> names;
    for (const toml::node& node : *traces) {
        if (!node.is_table()) table.fail(node, "trace: expected tables: [[trace]]");
        const Table entry(*node.as_table(), path);
        suite.traces.push_back(read_trace(entry, fs::path(path).parent_path(), usual));
        if (!names.insert(suite.traces.back().name).second)
            entry.fail(node, "there is a trace " + suite.traces.back().name + " before");
    }
    return suite;
}

} // namespace ffgpu::tools
