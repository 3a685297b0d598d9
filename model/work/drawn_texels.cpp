#include "model/work/drawn_texels.h"

#include "model/work/target_access.h"
#include "model/work/target_clear.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ffgpu::work {
namespace {

// Runs of pixels behind each other in device memory, also over the ends of rows without a gap.
void add_runs(const Surface& target,
              const std::vector<bool>& pixels,
              std::vector<ByteRange>& runs) {
    const std::uint64_t pixel = format_info(target.format).block_bytes;
    for (std::uint32_t y = 0; y < target.height; ++y) {
        const auto row = pixels.begin() + std::ptrdiff_t{y} * target.width;
        const auto end = row + target.width;
        const std::uint64_t at = target.address + std::uint64_t{y} * target.stride;
        for (auto from = std::find(row, end, true); from != end;) {
            const auto to = std::find(from, end, false);
            const ByteRange run{at + static_cast<std::uint64_t>(from - row) * pixel,
                                at + static_cast<std::uint64_t>(to - row) * pixel};
            if (!runs.empty() && runs.back().end == run.begin)
                runs.back().end = run.end;
            else
                runs.push_back(run);
            from = std::find(to, end, true);
        }
    }
}

} // namespace

void DrawnTexels::Drawn::mark(int x0, int x1, int y) {
    const auto row = pixels.begin() + std::ptrdiff_t{y} * target.width;
    std::fill(row + x0, row + x1, true);
}

std::optional<std::size_t> DrawnTexels::find(const Surface& target) {
    if (!addresses_.holds_texels({target.address, target.address + target.bytes()})) return {};
    for (std::size_t i = 0; i < drawn_.size(); ++i)
        if (drawn_[i].target == target) return i;
    drawn_.push_back({target, std::vector<bool>(std::size_t{target.width} * target.height)});
    return drawn_.size() - 1;
}

void DrawnTexels::clear(const WorkDraw& clear) {
    if (!clear.state) return;
    for (const TargetClear& of : target_clears(clear)) {
        const Rectangle& rectangle = of.fill.rectangle;
        if (of.bytes.touched == 0 || rectangle.empty()) continue;
        const std::optional<std::size_t> drawn = find(of.target);
        for (int y = rectangle.y0; drawn && y < rectangle.y1; ++y)
            drawn_[*drawn].mark(rectangle.x0, rectangle.x1, y);
    }
}

void DrawnTexels::begin(const WorkDraw& draw) {
    marked_.clear();
    if (!draw.state) return;
    const Registers& state = *draw.state;
    const auto mark = [this](const Surface& target, bool failed) {
        if (const std::optional<std::size_t> drawn = find(target))
            marked_.push_back({*drawn, failed});
    };
    for (unsigned target = 0; target < ColorTargets; ++target)
        if (color_access(state, target).written.touched != 0)
            mark(state.targets.color[target], false);
    const DepthAccess access = depth_access(state);
    if (access.writes())
        mark(state.targets.depth,
             (access.depth_failed.touched | access.stencil_failed.touched) != 0);
}

void DrawnTexels::add(std::span<const WorkQuad> quads) {
    for (const Marked& marked : marked_) {
        Drawn& drawn = drawn_[marked.drawn];
        for (const WorkQuad& quad : quads) {
            const unsigned written = marked.failed ? quad.covered : quad.after_depth;
            for (int lane = 0; lane < 4; ++lane)
                if (written >> lane & 1)
                    drawn.mark(quad.x + lane % 2, quad.x + lane % 2 + 1, quad.y + lane / 2);
        }
    }
}

std::vector<std::uint64_t> DrawnTexels::take(const Registers& draw) {
    marked_.clear();
    const bool reads = std::any_of(
        std::begin(draw.images), std::end(draw.images), [this](const TextureImage& image) {
            if (image.shape.kind == TextureKind::None) return false;
            const ByteRange read{image.address, image.address + texture_bytes(image.shape)};
            return std::any_of(drawn_.begin(), drawn_.end(), [&](const Drawn& drawn) {
                return drawn.bytes().overlaps(read);
            });
        });
    if (!reads) return {};
    std::vector<ByteRange> runs;
    for (const Drawn& drawn : std::exchange(drawn_, {}))
        for (unsigned sample = 0; sample < drawn.target.samples; ++sample)
            add_runs(drawn.target.plane(sample), drawn.pixels, runs);
    return addresses_.memory_written(runs);
}

} // namespace ffgpu::work
