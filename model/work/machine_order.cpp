#include "model/work/machine_order.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {
namespace {

bool overlap(std::uint64_t a, std::uint64_t a_bytes, std::uint64_t b, std::uint64_t b_bytes) {
    return a < b + b_bytes && b < a + a_bytes;
}

// The lines that `pixels` of a surface take, from its beginning: which lines does not matter, how
// many does.
LineRange
lines_of(const PlacedLevel& surface, std::uint64_t pixels, std::uint32_t line_bytes, bool write) {
    const std::uint64_t bytes =
        std::min(pixels * surface.layout.element_bytes, surface.layer_bytes);
    const std::uint64_t first = surface.base / line_bytes;
    return {first, first + (bytes + line_bytes - 1) / line_bytes, line_bytes, write};
}

} // namespace

void MachineOrder::command(std::shared_ptr<const WholeCommand> command) {
    switch (command->draw.kind) {
    case WorkKind::Draw:
    case WorkKind::Image:
        return draw(*command);
    case WorkKind::Clear:
        end_scene();
        return clear(command->draw);
    case WorkKind::Copy:
        end_scene();
        return copy(command->draw);
    }
}

void MachineOrder::draw(const WholeCommand& command) {
    const bool immediate = config_.raster.architecture == Architecture::Immediate;
    const Targets targets = command.draw.state ? command.draw.state->targets : Targets{};
    if (!scene_.draws.empty() && (!(targets == scene_targets_) || reads_scene(command)))
        end_scene();
    scene_targets_ = targets;
    append(command, config_, addresses_, scene_);
    if (immediate) end_scene();
}

void MachineOrder::end_scene() {
    if (scene_.draws.empty()) return;
    if (config_.raster.architecture == Architecture::TileBased)
        sort_by_screen_bins(config_.raster, scene_);
    out_.scene(std::exchange(scene_, {}));
}

bool MachineOrder::scene_draws_into(std::uint64_t at, std::uint64_t bytes) const {
    if (scene_.draws.empty()) return false;
    bool found = false;
    Targets::for_each(scene_targets_, [&](const Surface& target) {
        found = found || (target.format != Format::None &&
                          overlap(at, bytes, target.address, target.bytes()));
    });
    return found;
}

bool MachineOrder::reads_scene(const WholeCommand& command) const {
    const WorkDraw& draw = command.draw;
    if (draw.kind == WorkKind::Image &&
        scene_draws_into(draw.image.address, std::uint64_t{draw.image.stride} * draw.image.height))
        return true;
    return std::any_of(command.units.begin(), command.units.end(), [&](std::uint8_t unit) {
        const TextureImage& image = draw.state->images[unit];
        return image.shape.kind != TextureKind::None &&
               scene_draws_into(image.address, texture_bytes(image.shape));
    });
}

void MachineOrder::host_transfer(const HostTransfer& transfer) {
    if (scene_draws_into(transfer.at, transfer.bytes)) end_scene();
    if (transfer.is_write) addresses_.memory_written(transfer.at, transfer.bytes);
    out_.host_transfer(transfer);
}

void MachineOrder::end_frame(std::uint32_t frame) {
    end_scene();
    out_.end_frame(frame);
}

void MachineOrder::clear(const WorkDraw& draw) {
    PreparedTransfer transfer{.kind = WorkKind::Clear, .number = draw.number};
    const Registers& state = *draw.state;
    const std::uint64_t pixels = std::uint64_t{state.scissor.width} * state.scissor.height;
    const auto clear = [&](const Surface& target, const CacheShape& cache, bool depth) {
        if (target.format == Format::None) return;
        const PlacedLevel& place = addresses_.surface(target, cache);
        transfer.discards.push_back({depth, place.base, place.base + place.layer_bytes});
        transfer.lines.push_back(lines_of(place, pixels, cache.line_bytes, true));
    };
    if (draw.clear.color)
        for (const Surface& target : state.targets.color)
            clear(target, config_.color_cache, false);
    if (draw.clear.depth || draw.clear.stencil)
        clear(state.targets.depth, config_.depth_cache, true);
    out_.transfer(std::move(transfer));
}

void MachineOrder::copy(const WorkDraw& draw) {
    PreparedTransfer transfer{
        .kind = WorkKind::Copy, .number = draw.number, .writes_back_caches = true};
    const CopyRectangleCommand& copy = draw.copy;
    const std::uint64_t pixels = std::uint64_t{copy.width} * copy.height;
    const CacheShape& cache =
        format_info(copy.source.format).is_depth ? config_.depth_cache : config_.color_cache;
    const auto add = [&](const Surface& surface, bool write) {
        transfer.lines.push_back(
            lines_of(addresses_.surface(surface, cache), pixels, cache.line_bytes, write));
    };
    add(copy.source, false);
    add(copy.destination, true);
    addresses_.memory_written(copy.destination.address, copy.destination.bytes());
    out_.transfer(std::move(transfer));
}

} // namespace ffgpu::work
