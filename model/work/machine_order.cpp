#include "model/work/machine_order.h"

#include "model/work/target_clear.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {
namespace {

// Of a draw: they are told with it. More come in parts, some hundred microseconds' work each.
constexpr std::size_t FewQuads = 256;
constexpr std::size_t QuadsOfPart = 2048;
// Of draws that were told: their commands are kept.
constexpr std::size_t MostUntold = 1 << 18;

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

// Calls read(at, bytes) for each piece of device memory that the command reads, but its targets'.
template <class Read>
void for_each_read(const WholeCommand& command, Read&& read) {
    const WorkDraw& draw = command.draw;
    if (draw.kind == WorkKind::Image)
        read(draw.image.address, std::uint64_t{draw.image.stride} * draw.image.height);
    for (const std::uint8_t unit : command.units) {
        const TextureImage& image = draw.state->images[unit];
        if (image.shape.kind != TextureKind::None) read(image.address, texture_bytes(image.shape));
    }
}

} // namespace

PlacedLevel MachineOrder::shown() {
    if (shown_.format == Format::None) return {};
    return addresses_.surface(shown_, config_.color_cache);
}

PlacedLevel MachineOrder::place_of(const Surface& color, bool depth) {
    const auto found = drawn_.find(color.address);
    if (found == drawn_.end() || !(found->second.color[0] == color)) return {};
    const Surface& surface = depth ? found->second.depth : found->second.color[0];
    if (surface.format == Format::None) return {};
    return addresses_.surface(surface, shape(depth));
}

void MachineOrder::note_shown(const WorkDraw& draw) {
    const Surface& written = draw.kind == WorkKind::Copy ? draw.copy.destination
                             : draw.state                ? draw.state->targets.color[0]
                                                         : Surface{};
    if (written.format == Format::None || format_info(written.format).is_depth) return;
    shown_ = written;
    if (draw.kind != WorkKind::Copy) drawn_[written.address] = draw.state->targets;
}

void MachineOrder::command(std::shared_ptr<const WholeCommand> command) {
    const WorkDraw& draw = command->draw;
    note_shown(draw);
    last_number_ = draw.number;
    if (is_tile_based() && draw.kind != WorkKind::Copy) return gather(*command);
    switch (draw.kind) {
    case WorkKind::Draw:
    case WorkKind::Image:
        texels_drawn(*command);
        return this->draw(std::move(command));
    case WorkKind::Clear:
        texels_drawn(*command);
        return clear(draw);
    case WorkKind::Copy:
        if (tiles_.resolve(draw)) {
            end_scene();
            return tell_rewritten(addresses_.copied(draw.copy, rewritten()));
        }
        end_scene();
        return copy(draw);
    }
}

// What of it comes before its quads is told now: a machine whose host has nothing to send stands
// still, whatever it has to draw.
void MachineOrder::draw(std::shared_ptr<const WholeCommand> command) {
    PreparedScene scene;
    const WholeCommand& drawn = *command;
    Untold untold{std::move(command), {drawn, config_, addresses_, scene}};
    const std::size_t quads = untold.draw.quads_left();
    if (!out_.takes_parts() || quads <= FewQuads) {
        std::vector<PieceEnd> ends;
        untold.draw.add_quads(quads, scene, ends);
        set_ends(ends, scene);
        return out_.scene(std::move(scene));
    }
    scene.quads_to_come = quads;
    out_.scene(std::move(scene));
    untold_quads_ += quads;
    untold_.push_back(std::move(untold));
    while (untold_quads_ > MostUntold)
        tell_part();
}

bool MachineOrder::tell_part() {
    if (untold_.empty()) return false;
    PreparedPart part;
    DrawPreparation& draw = untold_.front().draw;
    draw.add_quads(QuadsOfPart, part, part.ends);
    untold_quads_ -= part.quads.size();
    out_.part(std::move(part));
    if (draw.quads_left() == 0) untold_.pop_front();
    return true;
}

void MachineOrder::gather(const WholeCommand& command) {
    const WorkDraw& draw = command.draw;
    const Targets targets = draw.state ? draw.state->targets : Targets{};
    if (!(targets == tiles_.targets()) || reads_scene(command)) end_scene();
    texels_drawn(command);
    for_each_read(command,
                  [&](std::uint64_t at, std::uint64_t bytes) { deferred_.need_range(at, bytes); });
    if (draw.kind == WorkKind::Clear) {
        tiles_.clear(draw);
    } else {
        tiles_.draw(command);
    }
}

// Stores that became due while the scene was planned come before it.
void MachineOrder::end_scene() {
    if (tiles_.empty()) return;
    PreparedScene scene = tiles_.take(deferred_);
    store_due();
    out_.scene(std::move(scene));
}

void MachineOrder::store_due() {
    PreparedTransfer transfer{.number = last_number_, .tile_lines = deferred_.take_due()};
    if (!transfer.tile_lines.empty()) out_.transfer(std::move(transfer));
}

bool MachineOrder::scene_draws_into(std::uint64_t at, std::uint64_t bytes) const {
    if (tiles_.empty()) return false;
    bool found = false;
    Targets::for_each(tiles_.targets(), [&](const Surface& target) {
        found = found || (target.format != Format::None &&
                          overlap(at, bytes, target.address, target.bytes()));
    });
    return found;
}

bool MachineOrder::reads_scene(const WholeCommand& command) const {
    bool found = false;
    for_each_read(command, [&](std::uint64_t at, std::uint64_t bytes) {
        found = found || scene_draws_into(at, bytes);
    });
    return found;
}

void MachineOrder::host_transfer(const HostTransfer& transfer) {
    if (scene_draws_into(transfer.at, transfer.bytes)) end_scene();
    deferred_.need_range(transfer.at, transfer.bytes);
    store_due();
    if (transfer.is_write)
        tell_rewritten(addresses_.memory_written(transfer.at, transfer.bytes, rewritten()));
    access(transfer);
    out_.host_transfer(transfer);
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
    deferred_.end_frame();
    store_due();
    if (!untold_.empty()) out_.end_commands();
    tell_parts();
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
    for (TargetClear& of : target_clears(draw)) {
        if (!is_asked_for(draw.clear, of.depth)) continue;
        of.fill.place = addresses_.surface(of.target, shape(of.depth));
        if (config_.target_lines) clear_lines(of.fill, of.depth, of.bytes, transfer);
        transfer.fills.push_back(of.fill);
    }
    out_.transfer(std::move(transfer));
}

void MachineOrder::copy(const WorkDraw& draw) {
    PreparedTransfer transfer{.kind = WorkKind::Copy,
                              .number = draw.number,
                              .writes_back_caches = true,
                              .register_writes = draw.register_writes,
                              .register_words = draw.register_words};
    const CopyRectangleCommand& copy = draw.copy;
    deferred_.need_range(copy.source.address, copy.source_bytes());
    deferred_.need_range(copy.destination.address, copy.destination.bytes());
    store_due();
    const bool depth = format_info(copy.source.format).is_depth;
    const CacheShape& cache = depth ? config_.depth_cache : config_.color_cache;
    const auto lines = [&](const Surface& surface, int x, int y) {
        return rectangle_lines(addresses_.surface(surface, cache),
                               LineGrain(cache.line_bytes),
                               {x, y, x + copy.width, y + copy.height},
                               whole_pixel(surface.format));
    };
    add_lines(lines(copy.source, copy.source_x, copy.source_y), depth, false, transfer);
    for (unsigned i = 1; i < copy.pictures; ++i)
        add_lines(
            lines(copy.source.plane(i), copy.source_x, copy.source_y), depth, false, transfer);
    add_lines(
        lines(copy.destination, copy.destination_x, copy.destination_y), depth, true, transfer);
    tell_rewritten(addresses_.copied(copy, rewritten()));
    out_.transfer(std::move(transfer));
}

// What the draw reads of textures that were drawn into before; what it draws into itself.
void MachineOrder::texels_drawn(const WholeCommand& command) {
    const WorkDraw& draw = command.draw;
    if (!draw.state) return;
    if (draw.kind == WorkKind::Clear) return drawn_texels_.clear(draw);
    tell_rewritten(drawn_texels_.take(*draw.state));
    drawn_texels_.begin(draw);
    drawn_texels_.add(command.quads);
}

void MachineOrder::tell_rewritten(std::vector<std::uint64_t>&& lines) {
    if (!lines.empty()) out_.texels_rewritten(std::move(lines));
}

// A scene that is still gathered may read the former texels: the driver leaves them where they are.
RewrittenLevel MachineOrder::rewritten() const {
    return tiles_.empty() ? config_.texel_cache.rewritten : RewrittenLevel::NewPlace;
}

} // namespace ffgpu::work
