// What a machine gains without the limits of each of its resources, measured: the same work on a
// machine for each, one after the other. Beside it what the machine itself reckons while it runs.

#pragma once

#include "model/timing/config.h"
#include "model/timing/resource.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct FrameGains {
    // Without a resource's limits.
    struct Without {
        timing::Resource resource = timing::Resource::Count;
        std::uint64_t cycles = 0; // of the frame
        double reckoned = 0;      // cycles that the machine itself says it would gain
    };

    std::uint32_t frame = 0;
    std::uint64_t cycles = 0;     // with all limits
    std::vector<Without> without; // in the order of the resources; those alone that have limits
};

// Plays the work file once, and once more for each resource. None, of any frame, where Ctrl-C came
// meanwhile (replay/interruption.h): it ends behind the frame. Throws InputError, MachineStuck.
std::vector<FrameGains> measure_gains(const std::string& work, const timing::TimingConfig& config);

// gains.csv in the folder: a row a frame and resource. Throws InputError. One that is there is of
// another run, and goes when this one's statistics come.
void remove_gains_file(const std::string& folder);
void write_gains_file(const std::vector<FrameGains>& frames, const std::string& folder);

// Of all frames together, a line a resource, the largest gain first.
std::string gains_summary(const std::vector<FrameGains>& frames);

} // namespace ffgpu::tools
