// The experiments, a function each: docs/experiments.md is what they tell.

#pragma once

#include "tests/experiments/figures/experiment.h"

#include <array>
#include <string>
#include <string_view>

namespace ffgpu::experiments {

Experiment miss_rates_by_size();        // P1
Experiment miss_rates_by_line();        // P2
Experiment miss_rates_by_ways();        // P3
Experiment kinds_of_misses();           // P4
Experiment bandwidth_saved();           // P5
Experiment latency_tolerance();         // P6
Experiment second_level();              // P7
Experiment miss_rates_by_tile();        // P8
Experiment homogeneous_rasterization(); // P9
Experiment compulsory_law();            // P10
Experiment parallel_caches();           // P12
Experiment speed();                     // P13
Experiment exported_look_ups();         // P14
Experiment fill_rates();                // P15

// What an experiment's figures hang on.
enum class Basis : std::uint8_t {
    Work, // what the functional GPU, or a formula, looks up
    Time, // the machine in time
    Host  // how fast the emulator is where it runs
};

struct Entry {
    std::string_view id;
    Experiment (*run)();
    Basis basis = Basis::Work;
};
inline constexpr std::array<Entry, 14> All{{{"P1", miss_rates_by_size},
                                            {"P2", miss_rates_by_line},
                                            {"P3", miss_rates_by_ways},
                                            {"P4", kinds_of_misses},
                                            {"P5", bandwidth_saved},
                                            {"P6", latency_tolerance, Basis::Time},
                                            {"P7", second_level},
                                            {"P8", miss_rates_by_tile},
                                            {"P9", homogeneous_rasterization},
                                            {"P10", compulsory_law},
                                            {"P12", parallel_caches},
                                            {"P13", speed, Basis::Host},
                                            {"P14", exported_look_ups},
                                            {"P15", fill_rates, Basis::Time}}};

} // namespace ffgpu::experiments
