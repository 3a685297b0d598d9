#include "model/timing/hierarchical_depth.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::timing {
namespace {

using Verdict = HierarchicalDepth::Verdict;
using Range = HierarchicalDepth::Range;

bool keeps_stencil(const StencilFace& face) {
    return face.write_mask == 0 ||
           (face.fail == StencilOp::Keep && face.depth_fail == StencilOp::Keep);
}

std::uint64_t line_of(const work::PlacedLevel& place,
                      const work::PreparedQuad& quad,
                      unsigned lane,
                      unsigned sample,
                      std::uint32_t line_bytes) {
    const std::uint32_t bytes = place.layout.element_bytes / place.samples;
    return (place.address(quad.x + (lane & 1u), quad.y + (lane >> 1), 0) + sample * bytes) /
           line_bytes;
}

} // namespace

bool failure_is_invisible(const Registers& state) {
    return state.depth.test_enable &&
           (!state.stencil.enable ||
            (keeps_stencil(state.stencil.front) && keeps_stencil(state.stencil.back)));
}

Verdict compare_range(Compare function, std::uint32_t depth, const Range& range) {
    const auto verdict = [](bool fails, bool passes) {
        return fails ? Verdict::Fails : passes ? Verdict::Passes : Verdict::Unknown;
    };
    const bool outside = depth < range.least || depth > range.greatest;
    const bool same = depth == range.least && depth == range.greatest;
    switch (function) {
    case Compare::Never:
        return Verdict::Fails;
    case Compare::Less:
        return verdict(depth >= range.greatest, depth < range.least);
    case Compare::Lequal:
        return verdict(depth > range.greatest, depth <= range.least);
    case Compare::Greater:
        return verdict(depth <= range.least, depth > range.greatest);
    case Compare::Gequal:
        return verdict(depth < range.least, depth >= range.greatest);
    case Compare::Equal:
        return verdict(outside, same);
    case Compare::Notequal:
        return verdict(same, outside);
    case Compare::Always:
        return Verdict::Passes;
    }
    return Verdict::Unknown;
}

void HierarchicalDepth::add(const work::PlacedLevel& place, Format format) {
    Target target;
    target.first_line = place.base / line_bytes_;
    target.bits = format == Format::Depth16 ? 16 : 24;
    target.greatest = (1u << target.bits) - 1;
    target.lines.assign((place.layer_bytes + line_bytes_ - 1) / line_bytes_, {0, target.greatest});
    targets_[target.first_line] = std::move(target);
}

HierarchicalDepth::Target* HierarchicalDepth::find(std::uint64_t line) {
    auto after = targets_.upper_bound(line);
    if (after == targets_.begin()) return nullptr;
    Target& target = (--after)->second;
    return line - target.first_line < target.lines.size() ? &target : nullptr;
}

void HierarchicalDepth::set(std::uint64_t line, Range range) {
    if (Target* const target = find(line)) target->lines[line - target->first_line] = range;
}

void HierarchicalDepth::forget(std::uint64_t line) {
    if (Target* const target = find(line))
        target->lines[line - target->first_line] = {0, target->greatest};
}

void HierarchicalDepth::widen(std::uint64_t line, std::uint32_t depth) {
    Target* const target = find(line);
    if (!target) return;
    Range& range = target->lines[line - target->first_line];
    range = {std::min(range.least, depth), std::max(range.greatest, depth)};
}

void HierarchicalDepth::widen(const work::PreparedDraw& draw,
                              const work::PreparedQuad& quad,
                              const SampleWords& depths) {
    std::size_t next = 0;
    for_each_sample(depths.samples, [&](unsigned lane, unsigned sample) {
        const std::uint32_t depth = depths.words[next++];
        const std::uint64_t line = line_of(draw.depth_place, quad, lane, sample, line_bytes_);
        const Target* const target = find(line);
        if (!target) return;
        const Range& range = target->lines[line - target->first_line];
        if (compare_range(draw.state->depth.compare, depth, range) != Verdict::Fails)
            widen(line, depth);
    });
}

void HierarchicalDepth::leave(std::uint64_t line,
                              const work::BlockShape& shape,
                              std::span<const std::byte> content) {
    if (content.empty() || pending.any(line)) return;
    Range range{~std::uint32_t{0}, 0};
    const std::size_t bytes = shape.sample_bytes();
    for (std::size_t at = 0; at < content.size(); at += bytes) {
        std::uint32_t word = 0;
        std::memcpy(&word, &content[at], bytes);
        const std::uint32_t depth = bytes == 4 ? word >> 8 : word;
        range = {std::min(range.least, depth), std::max(range.greatest, depth)};
    }
    set(line, range);
}

// Of the block that a line is in, as it is kept.
Range HierarchicalDepth::block(std::uint64_t line) const {
    const Target* const target = const_cast<HierarchicalDepth*>(this)->find(line);
    if (!target) return {};
    const std::uint64_t lines = config_.block_lines;
    const std::uint64_t begin = (line - target->first_line) / lines * lines;
    const std::uint64_t end = std::min<std::uint64_t>(begin + lines, target->lines.size());
    Range all = target->lines[begin];
    for (std::uint64_t i = begin + 1; i < end; ++i)
        all = {std::min(all.least, target->lines[i].least),
               std::max(all.greatest, target->lines[i].greatest)};
    const std::uint32_t lost =
        (1u << (target->bits - std::min(target->bits, config_.depth_bits))) - 1;
    all = {all.least & ~lost, all.greatest | lost};
    if (config_.keeps == CoarseDepth::Max) all.least = 0;
    return all;
}

Verdict HierarchicalDepth::test(const work::PreparedDraw& draw,
                                const work::PreparedQuad& quad,
                                const SampleWords& depths) const {
    const Registers& state = *draw.state;
    bool all_fail = failure_is_invisible(state);
    bool all_pass = !state.stencil.enable && !state.depth.bounds_enable;
    std::size_t next = 0;
    for_each_sample(depths.samples, [&](unsigned lane, unsigned sample) {
        const std::uint32_t depth = depths.words[next++];
        if (!all_fail && !all_pass) return;
        const Range range = block(line_of(draw.depth_place, quad, lane, sample, line_bytes_));
        const Verdict verdict = compare_range(state.depth.compare, depth, range);
        all_fail = all_fail && verdict == Verdict::Fails;
        all_pass = all_pass && verdict == Verdict::Passes;
    });
    if (all_fail) return Verdict::Fails;
    return all_pass && config_.keeps == CoarseDepth::MinMax && config_.accepts ? Verdict::Passes
                                                                               : Verdict::Unknown;
}

} // namespace ffgpu::timing
