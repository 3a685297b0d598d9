// RunDifference: what another configuration did to the same work.

#pragma once

#include "tools/report_page/run_figures.h"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

// What a change is measured by.
enum class EffectKind { Time, Traffic, Cache, Account };

struct ParameterChange {
    std::string name;
    nlohmann::json before, after;
};

// A figure that differs. `effect`: the change as a share of `whole`, which is what all figures of
// its kind are parts of: the cycles, the bytes, the look-ups of its cache. What bottlenecks took is
// told of runs that both tell of them.
struct FigureChange {
    EffectKind kind = EffectKind::Account;
    std::string name;
    std::uint64_t before = 0, after = 0, whole = 0;

    double effect() const; // 0 where there was no whole: a cache that the first run has not
};

struct RunDifference {
    std::vector<ParameterChange> configuration;
    std::vector<FigureChange> figures; // by the size of their effect, the largest first
};

// Throws InputError where the two did not do the same work. The names are those of the folders.
void check_same_work(const RunFigures& before,
                     const RunFigures& after,
                     const std::pair<std::string, std::string>& names);

// Of runs of the same work, both with timing.
RunDifference difference(const RunFigures& before, const RunFigures& after);

} // namespace ffgpu::tools
