#include "model/work/target_lookups.h"

#include <algorithm>
#include <span>

namespace ffgpu::work {

TargetLookups::TargetLookups(const WorkConfig& config)
    : enabled_(config.target_lines)
    , depth_grain_(config.depth_cache.line_bytes)
    , color_grain_(config.color_cache.line_bytes) {}

void TargetLookups::add(std::uint8_t tested, PreparedQuad& quad, PreparedQuads& out) {
    out_ = &out;
    quad.target_lines_begin = static_cast<std::uint32_t>(out_->target_lines.size());
    if (!enabled_) return;
    if (depth_ && tested != 0) add_depth(tested, quad);
    if (quad.after_depth != 0) add_colors(quad);
}

// Depths, and stencil values by how the tests ended.
void TargetLookups::add_depth(std::uint8_t tested, PreparedQuad& quad) {
    const WrittenQuad passed{
        depth_->quad_addresses(quad.x, quad.y), quad.after_depth, quad.samples_written};
    add_lines(*depth_, depth_grain_.line_bytes(), passed.addresses, tested);
    const std::span lines = std::span(out_->target_lines).subspan(quad.target_lines_begin);
    quad.depth_line_count = static_cast<std::uint8_t>(lines.size());
    const DepthAccess& access = depth_access_;
    const PixelBytes bytes{access.depth.touched | access.passed.touched,
                           access.depth.covered | access.passed.covered};
    for (const std::uint64_t line : lines) {
        WrittenBytes written = quad_bytes(*depth_, depth_grain_, passed, line, bytes);
        if ((access.depth_failed.touched | access.stencil_failed.touched) != 0)
            written |= failed_bytes(line, passed, tested, quad.after_stencil);
        out_->target_bytes.push_back(written);
    }
}

// Stencil values of the fragments that failed a test.
WrittenBytes TargetLookups::failed_bytes(std::uint64_t line,
                                         const WrittenQuad& passed,
                                         std::uint8_t tested,
                                         std::uint8_t after_stencil) const {
    WrittenQuad failed = passed;
    failed.lanes = static_cast<std::uint8_t>(after_stencil & ~passed.lanes);
    WrittenBytes written =
        quad_bytes(*depth_, depth_grain_, failed, line, depth_access_.depth_failed);
    failed.lanes = static_cast<std::uint8_t>(tested & ~after_stencil);
    written |= quad_bytes(*depth_, depth_grain_, failed, line, depth_access_.stencil_failed);
    return written;
}

void TargetLookups::add_colors(PreparedQuad& quad) {
    const std::size_t begin = out_->target_lines.size();
    for (Color& color : colors_) {
        color.quad = {
            color.place->quad_addresses(quad.x, quad.y), quad.after_depth, quad.samples_written};
        add_lines(*color.place, color_grain_.line_bytes(), color.quad.addresses, quad.after_depth);
    }
    const std::span lines = std::span(out_->target_lines).subspan(begin);
    quad.color_line_count = static_cast<std::uint8_t>(lines.size());
    for (const std::uint64_t line : lines) {
        WrittenBytes written;
        for (const Color& color : colors_)
            written |= quad_bytes(*color.place, color_grain_, color.quad, line, color.written);
        out_->target_bytes.push_back(written);
    }
}

// Each once, in the order of the lanes.
void TargetLookups::add_spread_lines(const PlacedLevel& place,
                                     std::uint32_t line_bytes,
                                     const std::array<std::uint64_t, 4>& addresses,
                                     std::uint8_t lanes) {
    const auto begin = static_cast<std::ptrdiff_t>(out_->target_lines.size());
    const auto add = [&](std::uint64_t line) {
        const auto first = out_->target_lines.begin() + begin;
        if (std::find(first, out_->target_lines.end(), line) == out_->target_lines.end())
            out_->target_lines.push_back(line);
    };
    for (unsigned lane = 0; lane < 4; ++lane) {
        if ((lanes >> lane & 1) == 0) continue;
        const std::uint64_t at = addresses[lane];
        const std::uint64_t end = at + place.layout.element_bytes;
        for (std::uint64_t line = quotient(at, line_bytes); line * line_bytes < end; ++line)
            add(line);
    }
}

} // namespace ffgpu::work
