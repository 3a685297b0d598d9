#include "tools/rtl/rtl_comparison.h"

#include "model/base/input_error.h"
#include "model/device/command_reader.h"
#include "tools/rtl/rtl_library.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// Draws that make fragments.
bool is_draw(Opcode opcode) {
    return opcode == Opcode::Draw || opcode == Opcode::DrawImage;
}

std::string difference_text(const RtlDifference& difference) {
    std::string text = fmt::format("rtl: draw {} is the first that parts\n", difference.draw);
    if (difference.stage) text += "rtl:   in " + stage_text(*difference.stage) + '\n';
    return text + target_text(difference.target);
}

// By units: what went through them, and what the model did in their place.
std::string share_text(const std::vector<rtl::StageShare>& shares) {
    std::string text;
    for (const rtl::StageShare& share : shares) {
        std::uint64_t all = 0;
        for (const rtl::StageShare& other : shares)
            if (other.units == share.units) all += other.fragments;
        const double percent =
            100 * static_cast<double>(share.fragments) / static_cast<double>(all);
        text += fmt::format("rtl: {}: {} fragments, {:.2f} %{}\n",
                            share.units,
                            share.fragments,
                            percent,
                            share.feature.empty() ? "" : " by the model: " + share.feature);
    }
    return text;
}

} // namespace

std::string stage_text(const rtl::StageDifference& stage) {
    return fmt::format("{}, primitive {}, quad ({}, {}), lane {}, {}: {:#x}, the model has {:#x}",
                       stage.unit,
                       stage.primitive,
                       stage.x,
                       stage.y,
                       stage.lane,
                       stage.field,
                       stage.got,
                       stage.expected);
}

std::unique_ptr<rtl::RtlStages> open_rtl_stages(const rtl::LoopOptions& options) {
    const auto open =
        reinterpret_cast<rtl::OpenRtlStages>(rtl_function("ffgpu_rtl.so", rtl::OpenRtlStagesName));
    std::string why;
    auto* const stages = open(options, why);
    if (!stages) throw InputError(why);
    return std::unique_ptr<rtl::RtlStages>(stages);
}

RtlComparison::RtlComparison(const rtl::LoopOptions& options)
    : rtl_(open_rtl_stages(options)) {}

void RtlComparison::attach(Device& device, FunctionalGpu& gpu) {
    device_ = &device;
    gpu_ = &gpu;
}

void RtlComparison::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    device_->write_memory(at, bytes);
    plain_.write_memory(at, bytes);
}

void RtlComparison::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    device_->read_memory(at, bytes);
}

void RtlComparison::submit(const CommandStream& commands) {
    CommandStream part;
    const auto submit_part = [&] {
        device_->submit(part);
        plain_.submit(part);
        part.words.clear();
    };
    for_each_command(commands.words, [&](const CommandReader& reader) {
        part.words.insert(part.words.end(), reader.whole().begin(), reader.whole().end());
        if (!is_draw(reader.opcode())) return;
        submit_part();
        compare_targets();
        ++next_draw_;
    });
    submit_part();
}

void RtlComparison::finish() {
    device_->finish();
    plain_.finish();
}

std::vector<const StatisticsGroup*> RtlComparison::statistics() const {
    return device_->statistics();
}

void RtlComparison::compare_targets() {
    gpu_->hide_from_work(true);
    RtlDifference found{.draw = next_draw_};
    found.target = targets_.compare(plain_.registers().targets, plain_, *gpu_);
    gpu_->hide_from_work(false);
    found.stage = rtl_->take_difference();
    ++draws_;
    if (found.target.target.empty() && !found.stage) return;
    ++different_;
    if (!difference_) difference_ = found;
}

std::string RtlComparison::summary() const {
    std::string text = share_text(rtl_->shares());
    if (equal())
        return text +
               fmt::format("rtl: {} draws, target bytes equal to the model's after each\n", draws_);
    return text + difference_text(*difference_) +
           fmt::format("rtl: {} of {} draws part\n", different_, draws_);
}

} // namespace ffgpu::tools
