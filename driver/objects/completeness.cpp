#include "driver/objects/completeness.h"

#include <algorithm>
#include <bit>

namespace ffgpu::gl {

namespace {

std::uint32_t interior(GLsizei size, GLint border) {
    return static_cast<std::uint32_t>(size - 2 * border);
}

struct Extent {
    std::uint32_t width, height, depth;

    bool operator==(const Extent&) const = default;
    Extent halved(std::uint32_t times) const {
        return {level_size(width, times), level_size(height, times), level_size(depth, times)};
    }
};

Extent extent_of(const TextureObject& texture, const TextureLevel& image) {
    const bool flat = texture.target() == TextureTarget::OneD;
    const bool solid = texture.target() == TextureTarget::ThreeD;
    return {interior(image.width, image.border),
            flat ? 1 : interior(image.height, image.border),
            solid ? interior(image.depth, image.border) : 1};
}

const TextureLevel* any_face(const TextureObject& texture, unsigned level) {
    for (unsigned face = 0; face < texture.faces(); ++face) {
        const TextureLevel& image = texture.level(face, level);
        if (image.defined()) return &image;
    }
    return nullptr;
}

// Each face of the level that is defined has this size and the format and border of `like`, and at
// least one face is defined.
bool fits(const TextureObject& texture, unsigned level, const TextureLevel& like, Extent extent) {
    if (!any_face(texture, level)) return false;
    for (unsigned face = 0; face < texture.faces(); ++face) {
        const TextureLevel& image = texture.level(face, level);
        if (!image.defined()) continue;
        if (image.internal_format != like.internal_format || image.border != like.border ||
            extent_of(texture, image) != extent) {
            return false;
        }
    }
    return true;
}

bool all_faces_defined(const TextureObject& texture, unsigned level) {
    for (unsigned face = 0; face < texture.faces(); ++face) {
        if (!texture.level(face, level).defined()) return false;
    }
    return true;
}

TextureKind kind_of(TextureTarget target) {
    switch (target) {
    case TextureTarget::OneD:
        return TextureKind::OneD;
    case TextureTarget::TwoD:
        return TextureKind::TwoD;
    case TextureTarget::Rectangle:
        return TextureKind::Rectangle;
    case TextureTarget::ThreeD:
        return TextureKind::ThreeD;
    default:
        return TextureKind::Cube;
    }
}

} // namespace

bool is_mipmap_filter(GLenum min_filter) {
    return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

TextureChain find_chain(const TextureObject& texture) {
    const GLint wanted_base = std::max(texture.parameters.base_level, 0);
    if (wanted_base >= static_cast<GLint>(MaxTextureLevels)) return {};
    const unsigned base = static_cast<unsigned>(wanted_base);
    const TextureLevel* image = any_face(texture, base);
    if (!image) return {};
    Extent extent = extent_of(texture, *image);
    if (!fits(texture, base, *image, extent)) return {};

    // Levels below the base level stay in the chain where they fit, so that moving the base level
    // does not move texels.
    unsigned root = base;
    const Extent base_extent = extent;
    while (root > 0) {
        const TextureLevel* below = any_face(texture, root - 1);
        if (!below) break;
        const Extent larger = extent_of(texture, *below);
        if (larger.halved(1) != extent || larger == extent) break;
        if (!fits(texture, root - 1, *image, larger)) break;
        extent = larger;
        --root;
    }
    const std::uint32_t largest = std::max({extent.width, extent.height, extent.depth});
    const unsigned end =
        std::min(root + static_cast<unsigned>(std::bit_width(largest)), MaxTextureLevels);
    unsigned last = base;
    while (last + 1 < end && fits(texture, last + 1, *image, extent.halved(last + 1 - root)))
        ++last;

    const unsigned needed_last = std::min<unsigned>(
        end - 1, static_cast<unsigned>(std::clamp(texture.parameters.max_level, 0, 1000)));
    TextureChain chain;
    chain.shape = {.kind = kind_of(texture.target()),
                   .format = image->format.format,
                   .width = extent.width,
                   .height = extent.height,
                   .depth = extent.depth,
                   .levels = last - root + 1,
                   .border = static_cast<std::uint32_t>(image->border)};
    chain.root = root;
    chain.base = base;
    chain.last = std::clamp(needed_last, base, last);
    chain.base_format = image->format.base;
    chain.srgb = image->format.srgb;

    chain.complete = all_faces_defined(texture, base);
    if (texture.target() == TextureTarget::Cube && base_extent.width != base_extent.height) {
        chain.complete = false;
    }
    if (is_mipmap_filter(texture.parameters.min_filter)) {
        if (needed_last < base || last < needed_last) chain.complete = false;
        for (unsigned level = base; level <= chain.last; ++level) {
            if (!all_faces_defined(texture, level)) chain.complete = false;
        }
    }
    return chain;
}

} // namespace ffgpu::gl
