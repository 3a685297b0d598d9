#include "tools/info/census.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::string describe(const TextureImage& image) {
    const TextureShape& shape = image.shape;
    std::string size = std::to_string(shape.width);
    if (shape.kind != TextureKind::OneD) size += fmt::format("x{}", shape.height);
    if (shape.kind == TextureKind::ThreeD) size += fmt::format("x{}", shape.depth);
    return fmt::format("{} {} {}{}, {} {}",
                       EnumeratorNames<TextureKind>[static_cast<std::size_t>(shape.kind)],
                       size,
                       format_info(shape.format).name,
                       image.srgb ? " (sRGB)" : "",
                       shape.levels,
                       shape.levels == 1 ? "level" : "levels");
}

std::string describe(const Surface& surface, unsigned samples) {
    return fmt::format("{}x{} {}{}",
                       surface.width,
                       surface.height,
                       format_info(surface.format).name,
                       samples > 1 ? fmt::format(", {} samples", samples) : "");
}

} // namespace

void Census::draw(const Registers& state, const DrawCommand& command) {
    ++draws_by_type_[static_cast<std::size_t>(command.primitive)];
    draw(state, command.count);
}

void Census::draw(const Registers& state, std::uint64_t vertices) {
    ++draws_;
    vertices_ += vertices;
    note_state(state);
}

void Census::image(const Registers& state) {
    ++images_;
    note_state(state);
}

void Census::note_state(const Registers& state) {
    for (const TextureImage& image : state.images)
        if (image.shape.kind != TextureKind::None)
            textures_.emplace(image.address, describe(image));
    const Surface& color = state.targets.color[0];
    if (color.format != Format::None) ++targets_[describe(color, state.targets.samples())];
}

std::string Census::text() const {
    std::string text = fmt::format(
        "draws: {} of {} vertices, {} images, {} clears, {} copies; {} bytes written by the host\n",
        draws_,
        vertices_,
        images_,
        clears_,
        copies_,
        uploaded_bytes_);
    for (std::size_t i = 0; i < draws_by_type_.size(); ++i)
        if (draws_by_type_[i] > 0)
            text +=
                fmt::format("  {:6} {}\n", draws_by_type_[i], EnumeratorNames<PrimitiveType>[i]);
    text += "targets, with the draws into each:\n";
    for (const auto& [target, draws] : targets_)
        text += fmt::format("  {:6} {}\n", draws, target);
    std::map<std::string, std::uint64_t> kinds;
    for (const auto& texture : textures_)
        ++kinds[texture.second];
    text += fmt::format("textures: {}\n", textures_.size());
    for (const auto& [kind, count] : kinds)
        text += fmt::format("  {:6} {}\n", count, kind);
    return text;
}

} // namespace ffgpu::tools
