#include "tools/explain/pixel_changes.h"

#include <algorithm>

namespace ffgpu::tools {
namespace {

bool holds(const Scissor& scissor, const SurfacePixel& pixel) {
    const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
    return x >= scissor.x && y >= scissor.y && x < scissor.x + scissor.width &&
           y < scissor.y + scissor.height;
}

bool is_in(const Surface& target, const SurfacePixel& pixel) {
    const auto found = pixel_at(target, pixel.address());
    return found && found->x == pixel.x && found->y == pixel.y;
}

bool draws_color(const Targets& targets, const PixelPlace& place) {
    return std::ranges::any_of(targets.color,
                               [&](const Surface& target) { return is_in(target, place.color); });
}

bool draws_depth(const Targets& targets, const PixelPlace& place) {
    return std::ranges::any_of(
        place.depths, [&](const SurfacePixel& pixel) { return is_in(targets.depth, pixel); });
}

std::optional<PixelEvent> upload(const TapeStep& step, const SurfacePixel& pixel) {
    const std::uint64_t size = format_info(pixel.surface.format).block_bytes;
    for (unsigned i = 0; i < pixel.surface.samples; ++i) {
        const std::uint64_t at = pixel.address() + i * pixel.surface.plane_bytes();
        if (at < step.at + step.bytes.size() && step.at < at + size)
            return PixelEvent{.kind = PixelEvent::Kind::Upload};
    }
    return std::nullopt;
}

std::optional<PixelEvent>
clear(const ClearCommand& command, const Registers& registers, const PixelPlace& place) {
    const bool reaches =
        (command.color && draws_color(registers.targets, place)) ||
        ((command.depth || command.stencil) && draws_depth(registers.targets, place));
    if (!reaches) return std::nullopt;
    return PixelEvent{.kind = PixelEvent::Kind::Clear,
                      .clear = command,
                      .outside_scissor = !holds(registers.scissor, place.color)};
}

// Of the pixels that an image covers its fragments tell, but stencil values make none.
std::optional<PixelEvent>
stencil_image(const DrawImageCommand& image, const Registers& registers, const PixelPlace& place) {
    if (image.format != Format::Stencil8 || !draws_depth(registers.targets, place))
        return std::nullopt;
    const auto covers = [](float from, float zoom, std::uint32_t count, std::uint32_t pixel) {
        const double begin = from, end = begin + double{zoom} * count, centre = pixel + 0.5;
        return std::min(begin, end) <= centre && centre < std::max(begin, end);
    };
    if (!covers(image.x, image.zoom_x, image.width, place.color.x) ||
        !covers(image.y, image.zoom_y, image.height, place.color.y))
        return std::nullopt;
    return PixelEvent{.kind = PixelEvent::Kind::StencilImage,
                      .outside_scissor = !holds(registers.scissor, place.color)};
}

std::optional<PixelEvent> copy(const CopyRectangleCommand& command, const PixelPlace& place) {
    const auto from = copied_from(command, place.color.address());
    if (!from) return std::nullopt;
    return PixelEvent{
        .kind = PixelEvent::Kind::Copy, .source = *from, .pictures = command.pictures};
}

} // namespace

std::optional<PixelEvent>
change_of(const TapeStep& step, const Registers& registers, const PixelPlace& place) {
    if (step.kind == TapeStep::Kind::Write) return upload(step, place.color);
    if (step.kind == TapeStep::Kind::Read) return std::nullopt;
    switch (step.opcode()) {
    case Opcode::Clear:
        return clear(step.as<ClearCommand>(), registers, place);
    case Opcode::DrawImage:
        return stencil_image(step.as<DrawImageCommand>(), registers, place);
    case Opcode::CopyRectangle:
        return copy(step.as<CopyRectangleCommand>(), place);
    default:
        return std::nullopt;
    }
}

} // namespace ffgpu::tools
