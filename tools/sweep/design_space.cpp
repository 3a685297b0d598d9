#include "tools/sweep/design_space.h"

#include "model/base/input_error.h"
#include "tools/config/config_file.h"
#include "tools/config/config_text.h"
#include "tools/sweep/space_axes.h"
#include "tools/sweep/text_hash.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

class Builder {
public:
    explicit Builder(const SpaceFile& file)
        : file_(file) {
        if (!file.base.empty()) read_config_file(file.base, base_);
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
            add(one, std::vector<std::size_t>(one.size(), 0));
        add_samples();
        if (space_.points.empty()) throw InputError(file_.path + ": the space has no point");
        space_.parameters.assign(parameters_.begin(), parameters_.end());
        for (DesignPoint& point : space_.points)
            point.values = values_of(point.configuration);
        return std::move(space_);
    }

private:
    static bool is_profile(const Axis& axis) { return axis.parameter.ends_with(".profile"); }

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
        if (ids_.insert(point.id).second) space_.points.push_back(std::move(point));
    }

    // The last axis changes fastest.
    void add_grid() {
        std::vector<std::size_t> choice(file_.grid.size(), 0);
        for (bool more = true; more;) {
            add(file_.grid, choice);
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
            add(file_.random_axes, choice);
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
    std::set<std::string> parameters_, ids_;
    DesignSpace space_;
};

} // namespace

DesignSpace read_design_space(const std::string& path) {
    const SpaceFile file = read_space_file(path);
    return Builder(file).space();
}

} // namespace ffgpu::tools
