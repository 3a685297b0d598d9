#include "tools/rtl/target_comparison.h"

#include "model/device/extents.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace ffgpu::tools {

TargetDifference
TargetComparison::compare(const Targets& targets, FunctionalGpu& expected, FunctionalGpu& got) {
    expected_gpu_ = &expected;
    got_gpu_ = &got;
    TargetDifference found;
    for (unsigned i = 0; i < ColorTargets; ++i)
        compare_surface(targets.color[i], fmt::format("colour target {}", i), found);
    compare_surface(targets.depth, "depth target", found);
    return found;
}

void TargetComparison::compare_surface(const Surface& surface,
                                       const std::string& name,
                                       TargetDifference& found) {
    if (surface.format == Format::None || !surface_fits(surface, got_gpu_->memory_size())) return;
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
bool TargetComparison::compare_bytes(DeviceAddress at, std::uint64_t size, std::uint64_t& first) {
    expected_.resize(size);
    got_.resize(size);
    expected_gpu_->read_memory(at, expected_);
    got_gpu_->read_memory(at, got_);
    if (expected_ == got_) return false;
    const auto parted = std::ranges::mismatch(expected_, got_).in1;
    first = static_cast<std::uint64_t>(parted - expected_.begin());
    got_gpu_->write_memory(at, expected_);
    return true;
}

std::string target_text(const TargetDifference& difference) {
    if (difference.target.empty()) return {};
    return fmt::format("rtl:   {}, pixel ({}, {}), sample {}: {:#x}, the model has {:#x}\n",
                       difference.target,
                       difference.x,
                       difference.y,
                       difference.sample,
                       difference.got,
                       difference.expected);
}

} // namespace ffgpu::tools
