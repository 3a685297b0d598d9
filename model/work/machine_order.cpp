#include "model/work/machine_order.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {
namespace {

bool overlap(std::uint64_t a, std::uint64_t a_bytes, std::uint64_t b, std::uint64_t b_bytes) {
    return a < b + b_bytes && b < a + a_bytes;
}

// The pixels of which a transfer moves bytes: part of a row, or whole rows.
Rectangle touched_pixels(const Surface& plane, const HostTransfer& transfer) {
    if (!overlap(transfer.at, transfer.bytes, plane.address, plane.bytes())) return {};
    const std::uint64_t begin = std::max<std::uint64_t>(transfer.at, plane.address) - plane.address;
    const std::uint64_t end = std::min(transfer.at + transfer.bytes - plane.address, plane.bytes());
    const auto first = static_cast<int>(begin / plane.stride);
    const auto last = static_cast<int>((end - 1) / plane.stride);
    if (first != last) return {0, first, plane.width, last + 1};
    const std::uint32_t pixel = format_info(plane.format).block_bytes;
    return {static_cast<int>(begin % plane.stride / pixel),
            first,
            static_cast<int>(((end - 1) % plane.stride) / pixel) + 1,
            first + 1};
}

void add_lines(const std::vector<WrittenLine>& lines,
               bool depth,
               bool write,
               PreparedTransfer& transfer) {
    for (const WrittenLine& line : lines)
        transfer.lines.push_back({depth, write, line});
}

} // namespace

PlacedLevel MachineOrder::shown() {
    if (shown_.format == Format::None) return {};
    return addresses_.surface(shown_, config_.color_cache);
}

void MachineOrder::note_shown(const WorkDraw& draw) {
    const Surface& written = draw.kind == WorkKind::Copy ? draw.copy.destination
                             : draw.state                ? draw.state->targets.color[0]
                                                         : Surface{};
    if (written.format != Format::None && !format_info(written.format).is_depth) shown_ = written;
}

void MachineOrder::command(std::shared_ptr<const WholeCommand> command) {
    note_shown(command->draw);
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
    access(transfer);
}

void MachineOrder::content(const std::shared_ptr<const SurfaceContent>& content) {
    end_scene();
    const Surface& surface = content->surface;
    const bool depth = format_info(surface.format).is_depth;
    if (std::find(known_.begin(), known_.end(), surface) == known_.end()) known_.push_back(surface);
    out_.content(
        {.depth = depth, .place = addresses_.surface(surface, shape(depth)), .content = content});
}

// By whole rows, if it is more than part of one.
void MachineOrder::access(const HostTransfer& transfer) {
    std::vector<TransferLine> lines;
    for (const Surface& surface : known_) {
        const bool depth = format_info(surface.format).is_depth;
        for (unsigned sample = 0; sample < surface.samples; ++sample) {
            const Rectangle rectangle = touched_pixels(surface.plane(sample), transfer);
            for (const WrittenLine& line :
                 rectangle_lines(addresses_.surface(surface, shape(depth)),
                                 LineGrain(shape(depth).line_bytes),
                                 rectangle,
                                 whole_pixel(surface.format)))
                lines.push_back({depth, transfer.is_write, line});
        }
    }
    if (!lines.empty()) out_.host_access(std::move(lines));
}

void MachineOrder::end_frame(std::uint32_t frame) {
    end_scene();
    out_.end_frame(frame);
}

// The lines that a clear writes of a surface, and those of which it writes all pixels.
void MachineOrder::clear_lines(const SurfaceFill& fill,
                               bool depth,
                               PixelBytes pixel,
                               PreparedTransfer& transfer) const {
    const LineGrain grain(shape(depth).line_bytes);
    const ImageLayout& layout = fill.place.layout;
    const Rectangle surface{0, 0, static_cast<int>(layout.width), static_cast<int>(layout.height)};
    const std::vector<WrittenLine> lines =
        rectangle_lines(fill.place, grain, fill.rectangle, pixel);
    const std::vector<WrittenLine> all =
        fill.rectangle == surface ? lines : rectangle_lines(fill.place, grain, surface, pixel);
    auto whole = all.begin();
    for (const WrittenLine& line : lines) {
        while (whole->number < line.number)
            ++whole;
        transfer.lines.push_back({depth, true, line, line.bytes == whole->bytes});
    }
}

void MachineOrder::clear(const WorkDraw& draw) {
    PreparedTransfer transfer{.kind = WorkKind::Clear,
                              .number = draw.number,
                              .register_writes = draw.register_writes,
                              .register_words = draw.register_words};
    const Registers& state = *draw.state;
    const Scissor& scissor = state.scissor;
    Rectangle rectangle{
        scissor.x, scissor.y, scissor.x + scissor.width, scissor.y + scissor.height};
    Targets::for_each(state.targets, [&rectangle](const Surface& target) {
        if (target.format != Format::None)
            rectangle = intersect(rectangle, {0, 0, target.width, target.height});
    });
    const auto clear = [&](const Surface& target, bool depth, PixelBytes pixel, SurfaceFill fill) {
        if (target.format == Format::None) return;
        fill.place = addresses_.surface(target, shape(depth));
        fill.rectangle = rectangle;
        clear_lines(fill, depth, pixel, transfer);
        transfer.fills.push_back(fill);
    };
    if (draw.clear.color)
        for (const Surface& target : state.targets.color)
            clear(target,
                  false,
                  cleared_color_bytes(target.format, state.blend.write_mask),
                  color_fill(state, target.format, draw.clear.color_value));
    const Surface& depth = state.targets.depth;
    if (draw.clear.depth || draw.clear.stencil)
        clear(depth,
              true,
              cleared_depth_bytes(depth.format, draw.clear, state.stencil.front.write_mask),
              depth_fill(state, depth.format, draw.clear));
    out_.transfer(std::move(transfer));
}

void MachineOrder::copy(const WorkDraw& draw) {
    PreparedTransfer transfer{.kind = WorkKind::Copy,
                              .number = draw.number,
                              .writes_back_caches = true,
                              .register_writes = draw.register_writes,
                              .register_words = draw.register_words};
    const CopyRectangleCommand& copy = draw.copy;
    const bool depth = format_info(copy.source.format).is_depth;
    const CacheShape& cache = depth ? config_.depth_cache : config_.color_cache;
    const auto lines = [&](const Surface& surface, int x, int y) {
        return rectangle_lines(addresses_.surface(surface, cache),
                               LineGrain(cache.line_bytes),
                               {x, y, x + copy.width, y + copy.height},
                               whole_pixel(surface.format));
    };
    add_lines(lines(copy.source, copy.source_x, copy.source_y), depth, false, transfer);
    add_lines(
        lines(copy.destination, copy.destination_x, copy.destination_y), depth, true, transfer);
    addresses_.memory_written(copy.destination.address, copy.destination.bytes());
    out_.transfer(std::move(transfer));
}

} // namespace ffgpu::work
