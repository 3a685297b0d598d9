// The experiments as a page of Markdown.

#pragma once

#include "tests/experiments/figures/experiment.h"

#include <string>
#include <vector>

namespace ffgpu::experiments {

// Links to its plots in the folder `plots`.
std::string section(const Experiment& experiment, const std::string& plots);
std::string page(const std::vector<Experiment>& experiments, const std::string& plots);

// P1: 98 met, 0 failed
std::string score_line(const std::string& name, const Score& score);

} // namespace ffgpu::experiments
