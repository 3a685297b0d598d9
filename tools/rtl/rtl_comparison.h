// RTL in the loop: what is drawn by Verilated units is drawn on a plain GPU as well, and the bytes
// of the targets are compared after every draw.

#pragma once

#include "model/gpu/functional_gpu.h"
#include "rtl/loop/rtl_stages.h"
#include "tools/rtl/rtl_device.h"
#include "tools/rtl/target_comparison.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

// The first draw whose targets, or values on the way to them, part.
struct RtlDifference {
    std::uint32_t draw = 0;
    std::optional<rtl::StageDifference> stage{}; // where values parted first
    TargetDifference target{};                   // of none: the stage's values alone did
};

// "fog, primitive 4, quad (48, 40), lane 1, color: 0x1, the model has 0x2"
std::string stage_text(const rtl::StageDifference& stage);

// Throws InputError where a unit does not exist, or ffgpu was built without Verilator.
std::unique_ptr<rtl::RtlStages> open_rtl_stages(const rtl::LoopOptions& options);

class RtlComparison final : public RtlDevice {
public:
    explicit RtlComparison(const rtl::LoopOptions& options);

    // For the GPU that is compared. It draws on one thread.
    const Stages& stages() const { return rtl_->table(); }
    void attach(Device& device, FunctionalGpu& gpu) override;
    void number_draws_from(std::uint32_t draw) override { next_draw_ = draw; }

    bool equal() const override { return !difference_; }
    const std::optional<RtlDifference>& difference() const { return difference_; }
    std::vector<rtl::StageShare> shares() const { return rtl_->shares(); }
    std::string summary() const override;

    std::uint64_t memory_size() const override { return device_->memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override;
    std::vector<const StatisticsGroup*> statistics() const override;

private:
    void compare_targets();

    std::unique_ptr<rtl::RtlStages> rtl_;
    Device* device_ = nullptr;
    FunctionalGpu* gpu_ = nullptr;
    FunctionalGpu plain_{{}};
    TargetComparison targets_;
    std::uint32_t next_draw_ = 0;
    std::uint64_t draws_ = 0, different_ = 0;
    std::optional<RtlDifference> difference_; // the first
};

} // namespace ffgpu::tools
