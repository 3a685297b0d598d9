#include "tools/sweep/space_axes.h"

#include "model/base/input_error.h"
#include "tools/config/toml_file.h"
#include "tools/sweep/design_space.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

class Reader {
public:
    explicit Reader(const std::string& path) { file_.path = path; }

    SpaceFile read() {
        const toml::table top = read_toml_file(file_.path);
        for (const auto& entry : top) {
            const std::string key(entry.first.str());
            const toml::node& node = entry.second;
            if (key == "base")
                file_.base = text(node, key), file_.base_line = node.source().begin.line;
            else if (key == "fixed")
                file_.fixed = axes(node, key, &Reader::one_value);
            else if (key == "grid")
                grid(node, key);
            else if (key == "list")
                list(node);
            else if (key == "random")
                random(node);
            else
                fail(node, key + ": expected base, fixed, grid, list or random");
        }
        return std::move(file_);
    }

private:
    // Told before it is gone through: that of a few long axes takes minutes.
    void grid(const toml::node& node, const std::string& key) {
        file_.grid = axes(node, key, &Reader::all_values);
        std::ranges::sort(file_.grid, {}, [](const Axis& axis) { // Tables know no order.
            return std::pair(axis.line, axis.column);
        });
        std::size_t points = 1;
        for (const Axis& axis : file_.grid) {
            points *= axis.values.size();
            if (points > MostPoints)
                fail(node, fmt::format("grid: the space has more than {} points", MostPoints));
        }
    }

    using Values = std::vector<std::string> (Reader::*)(const toml::node&, const std::string&);

    [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
        throw InputError(fmt::format("{}:{}: {}", file_.path, node.source().begin.line, what));
    }

    const toml::table& table(const toml::node& node, const std::string& name) const {
        if (!node.is_table()) fail(node, name + ": expected a table");
        return *node.as_table();
    }

    std::string text(const toml::node& node, const std::string& name) const {
        if (!node.is_string()) fail(node, name + ": expected a file or preset:NAME");
        return node.as_string()->get();
    }

    std::uint64_t count(const toml::node& node, const std::string& name) const {
        if (!node.is_integer() || node.as_integer()->get() < 0)
            fail(node, name + ": expected a number from 0");
        return static_cast<std::uint64_t>(node.as_integer()->get());
    }

    // Groups of parameters, as a configuration has them.
    std::vector<Axis> axes(const toml::node& node, const std::string& name, Values values) {
        std::vector<Axis> all;
        for (const auto& group : table(node, name)) {
            const std::string group_name(group.first.str());
            for (const auto& entry : table(group.second, fmt::format("{}.{}", name, group_name))) {
                const std::string parameter = group_name + '.' + std::string(entry.first.str());
                all.push_back(
                    {parameter,
                     (this->*values)(entry.second, fmt::format("{}: {}", name, parameter)),
                     entry.second.source().begin.line,
                     entry.second.source().begin.column});
            }
        }
        if (all.empty()) fail(node, name + ": no parameter is named");
        return all;
    }

    std::vector<std::string> one_value(const toml::node& node, const std::string& name) {
        if (node.is_integer()) return {std::to_string(node.as_integer()->get())};
        if (node.is_boolean()) return {node.as_boolean()->get() ? "true" : "false"};
        if (node.is_string()) return {'"' + node.as_string()->get() + '"'};
        fail(node, name + ": expected a number, a name, true or false");
    }

    std::vector<std::string> all_values(const toml::node& node, const std::string& name) {
        if (node.is_table()) return range(*node.as_table(), name);
        if (!node.is_array())
            fail(node, name + ": expected values, [1, 2, 4], or { from = 1, to = 4 }");
        std::vector<std::string> all;
        for (const toml::node& value : *node.as_array())
            all.push_back(one_value(value, name).front());
        if (all.empty()) fail(node, name + ": the axis has no value");
        return all;
    }

    // { from = 16, to = 1024, step = 16 }, or powers_of_two = true
    std::vector<std::string> range(const toml::table& limits, const std::string& name) {
        std::uint64_t from = 0, to = 0, step = 1;
        bool has_from = false, has_to = false, has_step = false, doubles = false;
        for (const auto& entry : limits) {
            const std::string_view key = entry.first.str();
            const std::string full = name + '.' + std::string(key);
            if (key == "from")
                from = count(entry.second, full), has_from = true;
            else if (key == "to")
                to = count(entry.second, full), has_to = true;
            else if (key == "step")
                step = count(entry.second, full), has_step = true;
            else if (key == "powers_of_two" && entry.second.is_boolean())
                doubles = entry.second.as_boolean()->get();
            else
                fail(entry.second, full + ": expected from, to, step or powers_of_two = true");
        }
        if (!has_from || !has_to) fail(limits, name + ": from or to is missing");
        if (step == 0) fail(limits, name + ": a step of 0");
        if (doubles && has_step) fail(limits, name + ": powers of two have no step");
        if (doubles && from == 0) fail(limits, name + ": powers of two begin with 1 or more");
        std::vector<std::string> all;
        for (std::uint64_t value = from; value <= to; value = doubles ? 2 * value : value + step) {
            all.push_back(std::to_string(value));
            if (all.size() > MostPoints) fail(limits, name + ": the axis has too many values");
        }
        if (all.empty()) fail(limits, name + ": the axis has no value");
        return all;
    }

    void list(const toml::node& node) {
        if (!node.is_array()) fail(node, "list: expected [[list]], a table a point");
        for (const toml::node& point : *node.as_array())
            file_.list.push_back(axes(point, "list", &Reader::one_value));
    }

    void random(const toml::node& node) {
        for (const auto& entry : table(node, "random")) {
            const std::string key(entry.first.str());
            if (key == "samples")
                file_.random_samples = count(entry.second, "random.samples");
            else if (key == "seed")
                file_.random_seed = count(entry.second, "random.seed");
            else if (key == "axes")
                file_.random_axes = axes(entry.second, "random.axes", &Reader::all_values);
            else
                fail(entry.second, "random." + key + ": expected samples, seed or axes");
        }
        if (file_.random_axes.empty()) fail(node, "random: axes are missing");
        if (file_.random_samples == 0 || file_.random_samples > MostPoints)
            fail(node, fmt::format("random: expected samples = 1 to {}", MostPoints));
    }

    SpaceFile file_;
};

} // namespace

SpaceFile read_space_file(const std::string& path) {
    return Reader(path).read();
}

} // namespace ffgpu::tools
