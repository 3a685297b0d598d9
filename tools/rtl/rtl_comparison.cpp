#include "tools/rtl/rtl_comparison.h"

#include "model/base/input_error.h"
#include "model/device/command_reader.h"
#include "model/device/extents.h"
#include "tools/files/library_folder.h"

#include <algorithm>
#include <cstring>

#include <dlfcn.h>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::unique_ptr<rtl::RtlStages> open_stages(const rtl::LoopOptions& options) {
    const std::string library = (find_library_folder() / "ffgpu_rtl.so").string();
    void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = handle ? ::dlsym(handle, rtl::OpenRtlStagesName) : nullptr;
    if (!symbol)
        throw InputError("--rtl: the units in RTL are not there, which Verilator makes when ffgpu "
                         "is built: " +
                         std::string(::dlerror()));
    std::string why;
    auto* const stages = reinterpret_cast<rtl::OpenRtlStages>(symbol)(options, why);
    if (!stages) throw InputError("--rtl: " + why);
    return std::unique_ptr<rtl::RtlStages>(stages);
}

// Draws that make fragments.
bool is_draw(Opcode opcode) {
    return opcode == Opcode::Draw || opcode == Opcode::DrawImage;
}

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

std::string difference_text(const RtlDifference& difference) {
    std::string text = fmt::format("rtl: draw {} is the first that parts\n", difference.draw);
    if (difference.stage) text += "rtl:   in " + stage_text(*difference.stage) + '\n';
    if (!difference.target.empty())
        text += fmt::format("rtl:   {}, pixel ({}, {}), sample {}: {:#x}, the model has {:#x}\n",
                            difference.target,
                            difference.x,
                            difference.y,
                            difference.sample,
                            difference.got,
                            difference.expected);
    return text;
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

RtlComparison::RtlComparison(const rtl::LoopOptions& options)
    : rtl_(open_stages(options)) {}

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

// What parts is made equal again, so that each draw is judged by itself.
void RtlComparison::compare_targets() {
    gpu_->hide_from_work(true);
    RtlDifference found{.draw = next_draw_};
    const Targets& targets = plain_.registers().targets;
    for (unsigned i = 0; i < ColorTargets; ++i)
        compare_surface(targets.color[i], fmt::format("colour target {}", i), found);
    compare_surface(targets.depth, "depth target", found);
    gpu_->hide_from_work(false);
    found.stage = rtl_->take_difference();
    ++draws_;
    if (found.target.empty() && !found.stage) return;
    ++different_;
    if (!difference_) difference_ = found;
}

void RtlComparison::compare_surface(const Surface& surface,
                                    const std::string& name,
                                    RtlDifference& found) {
    if (surface.format == Format::None || !surface_fits(surface, memory_size())) return;
    std::uint64_t first = 0;
    if (!compare_bytes(surface.address, surface.bytes(), first) || !found.target.empty()) return;
    const unsigned bytes = format_info(surface.format).block_bytes;
    const std::uint64_t in_plane = first % surface.plane_bytes();
    found.target = name;
    found.sample = static_cast<unsigned>(first / surface.plane_bytes());
    found.y = static_cast<unsigned>(in_plane / surface.stride);
    found.x = static_cast<unsigned>(in_plane % surface.stride / bytes);
    const std::uint64_t at = first - in_plane % surface.stride % bytes;
    std::memcpy(&found.expected, expected_.data() + at, std::min<std::size_t>(bytes, 4));
    std::memcpy(&found.got, got_.data() + at, std::min<std::size_t>(bytes, 4));
}

// True: they part, first at `first`.
bool RtlComparison::compare_bytes(DeviceAddress at, std::uint64_t size, std::uint64_t& first) {
    expected_.resize(size);
    got_.resize(size);
    plain_.read_memory(at, expected_);
    gpu_->read_memory(at, got_);
    if (expected_ == got_) return false;
    const auto parted = std::ranges::mismatch(expected_, got_).in1;
    first = static_cast<std::uint64_t>(parted - expected_.begin());
    gpu_->write_memory(at, expected_);
    return true;
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
