#include "tools/sweep/design_space.h"

#include "model/base/input_error.h"
#include "model/timing/machine_checks.h"
#include "tools/config/config_file.h"
#include "tools/config/config_text.h"
#include "tools/sweep/space_axes.h"
#include "tools/sweep/text_hash.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// Values that are right, each by itself, but not together.
class NoMachine : public InputError {
public:
    using InputError::InputError;
};

class Builder {
public:
    explicit Builder(const SpaceFile& file)
        : file_(file) {
        if (!file.base.empty()) read_base();
        for (const std::vector<Axis>* const axes : {&file.grid, &file.random_axes})
            for (const Axis& axis : *axes)
                parameters_.insert(axis.parameter);
        for (const std::vector<Axis>& one : file.list)
            for (const Axis& axis : one)
                parameters_.insert(axis.parameter);
    }

    DesignSpace space() {
        if (!file_.grid.empty()) add_grid();
        for (const std::vector<Axis>& one : file_.list)
            add_listed(one);
        add_samples();
        if (space_.points.empty() && space_.left_out > 0)
            throw InputError(file_.path + ": no point is a machine: " + space_.why);
        if (space_.points.empty()) throw InputError(file_.path + ": the space has no point");
        space_.parameters.assign(parameters_.begin(), parameters_.end());
        for (DesignPoint& point : space_.points)
            point.values = values_of(point.configuration);
        return std::move(space_);
    }

private:
    static bool is_profile(const Axis& axis) { return axis.parameter.ends_with(".profile"); }

    void read_base() {
        try {
            read_config_file(file_.base, base_);
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("{}:{}: base: {}", file_.path, file_.base_line, error.what()));
        }
    }

    void set(Configuration& configuration, const Axis& axis, std::size_t value) const {
        // Lines before it, so that what is wrong with it is told with its line.
        apply_text(std::string(axis.line - 1, '\n') + axis.parameter + " = " + axis.values[value],
                   file_.path,
                   configuration);
    }

    // `choice`: which value of each axis.
    void add(const std::vector<Axis>& axes, const std::vector<std::size_t>& choice) {
        if (space_.points.size() == MostPoints)
            throw InputError(
                fmt::format("{}: the space has more than {} points", file_.path, MostPoints));
        DesignPoint point{.id = {}, .configuration = base_, .values = {}};
        // A group's `profile` sets others of its parameters, so it comes first.
        for (const bool profiles : {true, false}) {
            for (const Axis& axis : file_.fixed)
                if (is_profile(axis) == profiles) set(point.configuration, axis, 0);
            for (std::size_t i = 0; i < axes.size(); ++i)
                if (is_profile(axes[i]) == profiles) set(point.configuration, axes[i], choice[i]);
        }
        point.id = text_hash(to_toml(point.configuration));
        const auto [known, is_new] = ids_.try_emplace(point.id);
        if (is_new) known->second = why_no_machine(point.configuration.timing);
        if (!known->second.empty()) throw NoMachine(known->second);
        if (is_new) space_.points.push_back(std::move(point));
    }

    static std::string why_no_machine(const timing::TimingConfig& config) {
        try {
            timing::check_machine(config);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    // Axes that are combined may contradict each other here and there: a point less.
    void add_combination(const std::vector<Axis>& axes, const std::vector<std::size_t>& choice) {
        const std::size_t before = ids_.size();
        try {
            add(axes, choice);
        } catch (const NoMachine& error) { // Not where a value is wrong by itself.
            if (ids_.size() > before && space_.left_out++ == 0) space_.why = error.what();
        }
    }

    void add_listed(const std::vector<Axis>& axes) {
        try {
            add(axes, std::vector<std::size_t>(axes.size(), 0));
        } catch (const NoMachine& error) {
            throw InputError(
                fmt::format("{}:{}: list: {}", file_.path, axes.front().line, error.what()));
        }
    }

    // The last axis changes fastest.
    void add_grid() {
        std::vector<std::size_t> choice(file_.grid.size(), 0);
        for (bool more = true; more;) {
            add_combination(file_.grid, choice);
            std::size_t axis = choice.size();
            while (axis > 0 && ++choice[axis - 1] == file_.grid[axis - 1].values.size())
                choice[--axis] = 0;
            more = axis > 0;
        }
    }

    void add_samples() {
        RawRandom random(file_.random_seed);
        for (std::uint64_t sample = 0; sample < file_.random_samples; ++sample) {
            std::vector<std::size_t> choice;
            for (const Axis& axis : file_.random_axes)
                choice.push_back(random.below(axis.values.size()));
            add_combination(file_.random_axes, choice);
        }
    }

    std::vector<std::string> values_of(const Configuration& configuration) const {
        std::map<std::string, std::string> all = parameter_values(configuration);
        std::vector<std::string> values;
        for (const std::string& parameter : parameters_)
            values.push_back(all.at(parameter));
        return values;
    }

    const SpaceFile& file_;
    Configuration base_;
    std::set<std::string> parameters_;
    std::map<std::string, std::string> ids_; // why it is no machine; empty: it is one
    DesignSpace space_;
};

} // namespace

DesignSpace read_design_space(const std::string& path) {
    const SpaceFile file = read_space_file(path);
    return Builder(file).space();
}

} // namespace ffgpu::tools
