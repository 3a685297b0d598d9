// Runs the machine in time on a work bin and hands out all its counters by name.

#pragma once

#include "model/timing/account.h"
#include "model/timing/gpu_timing.h"
#include "model/work/command_assembler.h"

#include <map>
#include <memory>
#include <string>

namespace ffgpu::timing {

using Figures = std::map<std::string, std::uint64_t>;

inline Figures figures_of(const GpuTiming& timing) {
    Figures figures;
    for (const StatisticsGroup* group : timing.statistics()) {
        for (const Counter& counter : group->counters())
            figures[std::string(counter.name())] = counter.value();
    }
    for (const std::string& unit : timing.unit_names()) {
        std::uint64_t sum = 0;
        for (const std::string_view activity : ActivityNames)
            sum += figures.at(unit + '_' + std::string(activity) + "_cycles");
        figures[unit + "_sum"] = sum;
    }
    return figures;
}

inline Figures
run(const TimingConfig& config, const WorkBin& bin, const Evaluation& evaluation = {}) {
    GpuTiming timing(config, evaluation);
    work::CommandAssembler assembler(timing);
    assembler.bin(std::make_shared<const WorkBin>(bin));
    assembler.end_frame(0);
    return figures_of(timing);
}

} // namespace ffgpu::timing
