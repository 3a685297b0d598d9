// The targets of two GPUs, byte for byte.

#pragma once

#include "model/gpu/functional_gpu.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::tools {

// Where two parted first, if `target` names one.
struct TargetDifference {
    std::string target{};
    unsigned x = 0, y = 0, sample = 0;
    std::uint32_t expected = 0, got = 0;
};

class TargetComparison {
public:
    // What parted is made equal in `got`, so that each draw is judged by itself.
    TargetDifference compare(const Targets& targets, FunctionalGpu& expected, FunctionalGpu& got);

private:
    void compare_surface(const Surface& surface, const std::string& name, TargetDifference& found);
    bool compare_bytes(DeviceAddress at, std::uint64_t size, std::uint64_t& first);

    FunctionalGpu* expected_gpu_ = nullptr;
    FunctionalGpu* got_gpu_ = nullptr;
    std::vector<std::byte> expected_, got_;
};

// A line for people, empty where nothing parted.
std::string target_text(const TargetDifference& difference);

} // namespace ffgpu::tools
