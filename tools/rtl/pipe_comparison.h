// Whole frames by the fragment pipe in RTL: a second GPU gets all commands, and the Verilated pipe
// draws on it in its place. The bytes of the targets are compared with the model's after every
// draw. What the pipe leaves to the host's hands is drawn by the second GPU, named and counted.

#pragma once

#include "rtl/pipe/pipe.h"
#include "tools/rtl/pipe_cycles.h"
#include "tools/rtl/pipe_records.h"
#include "tools/rtl/rtl_device.h"
#include "tools/rtl/target_comparison.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace ffgpu::tools {

struct PipeDifference {
    std::uint32_t draw = 0;
    bool stands = false; // The pipe did not end the draw.
    TargetDifference target{};
};

// Throws InputError where ffgpu was built without Verilator, or cannot do what is wanted.
std::unique_ptr<rtl::Pipe> open_rtl_pipe(const rtl::PipeOptions& options);

class PipeComparison final : public RtlDevice {
public:
    // Throws InputError where ffgpu was built without Verilator, and where the file cannot be made
    // that the cycles of each draw are written to; empty: none.
    explicit PipeComparison(const rtl::PipeOptions& options = {}, const std::string& cycles = {});

    void attach(Device& device, FunctionalGpu& gpu) override;
    void number_draws_from(std::uint32_t draw) override { next_draw_ = draw; }

    bool equal() const override { return !difference_; }
    std::string summary() const override;
    void commit() override;
    const std::optional<PipeDifference>& difference() const { return difference_; }
    // Fragments by the reason for which the pipe did not draw them; of none, those that it did.
    const std::map<std::string, std::uint64_t>& fragments() const { return fragments_; }

    std::uint64_t memory_size() const override { return device_->memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override;
    std::vector<const StatisticsGroup*> statistics() const override;

private:
    void draw(const CommandStream& command, std::string reason);
    std::string draw_by_pipe(const DrawCommand& command);
    void compare(const std::string& reason);
    std::uint64_t model_fragments() const;
    std::string share_text() const;

    std::unique_ptr<rtl::Pipe> pipe_;
    Device* device_ = nullptr; // the model's
    FunctionalGpu* gpu_ = nullptr;
    std::unique_ptr<FunctionalGpu> drawn_; // by the pipe
    std::unique_ptr<PipeRecords> records_;
    TargetComparison targets_;
    std::optional<PipeCycles> cycles_;
    std::map<std::string, std::uint64_t> fragments_;
    bool stands_ = false; // in the draw under way
    std::uint32_t next_draw_ = 0;
    std::uint64_t draws_ = 0, by_pipe_ = 0, different_ = 0, counted_fragments_ = 0;
    std::optional<PipeDifference> difference_; // the first
};

} // namespace ffgpu::tools
