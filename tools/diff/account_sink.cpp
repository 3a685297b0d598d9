#include "tools/diff/account_sink.h"

#include <fmt/format.h>

namespace ffgpu::tools {

std::string part_name(AccountPart part) {
    const std::string_view name = AccountStageNames[static_cast<std::size_t>(part.stage)];
    switch (part.stage) {
    case AccountStage::TexCoords:
    case AccountStage::Texture:
    case AccountStage::Environment:
    case AccountStage::ColorWrite:
        return fmt::format("{} {}", name, part.unit);
    case AccountStage::Target:
        return part.unit == AccountPart::DepthUnit ? fmt::format("{} depth", name)
                                                   : fmt::format("{} color {}", name, part.unit);
    default:
        return std::string(name);
    }
}

std::string place_name(const AccountPlace& place) {
    switch (place.kind) {
    case AccountPlace::Kind::Primitive:
        return fmt::format("primitive {} piece {}", place.primitive, place.piece);
    case AccountPlace::Kind::Fragment:
        return fmt::format("primitive {} piece {} quad {},{} lane {} sample {}",
                           place.primitive,
                           place.piece,
                           place.x,
                           place.y,
                           place.lane,
                           place.sample);
    case AccountPlace::Kind::Pixel:
        return fmt::format("pixel {},{} sample {}", place.x, place.y, place.sample);
    case AccountPlace::Kind::Numbered:
        break;
    }
    return fmt::format("number {}", place.primitive);
}

} // namespace ffgpu::tools
