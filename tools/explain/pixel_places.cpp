#include "tools/explain/pixel_places.h"

#include <algorithm>

namespace ffgpu::tools {
std::optional<SurfacePixel> pixel_at(const Surface& surface, std::uint64_t address) {
    if (surface.format == Format::None || surface.stride == 0 || address < surface.address)
        return std::nullopt;
    const std::uint64_t offset = address - surface.address;
    const std::uint64_t y = offset / surface.stride,
                        x = offset % surface.stride / format_info(surface.format).block_bytes;
    if (x >= surface.width || y >= surface.height) return std::nullopt;
    return SurfacePixel{surface, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
}

std::optional<SurfacePixel> copied_from(const CopyRectangleCommand& copy, std::uint64_t address) {
    const auto to = pixel_at(copy.destination, address);
    if (!to || to->x < copy.destination_x || to->y < copy.destination_y) return std::nullopt;
    const std::uint32_t x = to->x - copy.destination_x, y = to->y - copy.destination_y;
    if (x >= copy.width || y >= copy.height) return std::nullopt;
    return SurfacePixel{copy.source, copy.source_x + x, copy.source_y + y};
}

PixelSources::PixelSources(const FrameTape& tape)
    : steps_(tape.steps.size()) {
    RegisterFile registers;
    const auto follow = [&](const CommandStream& stream) {
        for_each_command(stream.words, [&](const CommandReader& reader) {
            if (reader.opcode() == Opcode::WriteRegister) registers.write(reader.register_write());
        });
    };
    CommandStream before;
    write_changes(Registers{}, tape.registers, before);
    follow(before);
    for (std::size_t i = 0; i < steps_; ++i) {
        const TapeStep& step = tape.steps[i];
        if (step.kind != TapeStep::Kind::Command) continue;
        follow(step.command);
        if (step.opcode() == Opcode::CopyRectangle)
            copies_.emplace_back(i, step.as<CopyRectangleCommand>());
        const bool draws = is_numbered(step.opcode()) || step.opcode() == Opcode::Clear;
        const Targets& targets = registers.values().targets;
        if (draws && std::ranges::find(targets_, targets) == targets_.end())
            targets_.push_back(targets);
    }
}

std::vector<PixelPlace> PixelSources::places(const SurfacePixel& pixel) const {
    std::vector<PixelPlace> places{{pixel, steps_}};
    std::vector<bool> is_copy{false}; // by place: what was copied to it is known
    for (std::size_t later = copies_.size(); later > 0; --later) {
        const auto& [step, copy] = copies_[later - 1];
        for (std::size_t i = 0, end = places.size(); i < end; ++i) {
            const auto source = copied_from(copy, places[i].color.address());
            if (!source || is_copy[i]) continue;
            is_copy[i] = true;
            const unsigned pictures = copy.pictures;
            for (unsigned picture = 0; picture < pictures; ++picture) {
                PixelPlace& place = places.emplace_back(PixelPlace{*source, step});
                if (pictures > 1) place.color.surface = source->surface.plane(picture);
                place.picture = picture;
                place.pictures = pictures;
                is_copy.push_back(false);
            }
        }
    }
    for (PixelPlace& place : places)
        for (const Targets& targets : targets_)
            for (const Surface& color : targets.color) {
                const auto at = pixel_at(color, place.color.address());
                const SurfacePixel depth =
                    at ? SurfacePixel{targets.depth, at->x, at->y} : SurfacePixel{};
                if (depth.surface.format == Format::None || depth.x >= depth.surface.width ||
                    depth.y >= depth.surface.height)
                    continue;
                if (std::ranges::find(place.depths, depth) == place.depths.end())
                    place.depths.push_back(depth);
            }
    return places;
}

} // namespace ffgpu::tools
