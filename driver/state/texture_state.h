// The texture units: bindings, enables, environments and coordinate generation
// (GL 1.5, 3.8; 2.11.4). Texture matrices are with the transform state, current coordinates with
// the current state.

#pragma once

#include "driver/gl_types.h"
#include "model/device/layout/limits.h"

#include <array>
#include <cstdint>
#include <memory>

namespace ffgpu::gl {

class TextureObject; // driver/objects/texture_object.h

// In rising precedence: of the enabled targets of a unit the last one is in force (GL 1.5, 3.8.15;
// ARB_texture_rectangle).
enum class TextureTarget : std::uint8_t { OneD, TwoD, Rectangle, ThreeD, Cube, Count };
constexpr std::size_t TextureTargets = static_cast<std::size_t>(TextureTarget::Count);

// GL 1.5, 3.8.13; GL_COMBINE4_NV takes the fourth argument as well.
struct TextureEnvironment {
    GLenum mode = GL_MODULATE;
    std::array<float, 4> color{0, 0, 0, 0};
    GLenum combine_rgb = GL_MODULATE;
    GLenum combine_alpha = GL_MODULATE;
    std::array<GLenum, 4> source_rgb{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_ZERO};
    std::array<GLenum, 4> source_alpha{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT, GL_ZERO};
    std::array<GLenum, 4> operand_rgb{
        GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_COLOR};
    std::array<GLenum, 4> operand_alpha{
        GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
    float rgb_scale = 1;
    float alpha_scale = 1;
    float lod_bias = 0;
    bool coord_replace = false; // GL_POINT_SPRITE, GL_COORD_REPLACE
};

// One coordinate of one unit. The eye plane is kept in eye coordinates: it is transformed by the
// inverse of the model-view matrix that is current when it is set.
struct TexGen {
    bool enabled = false;
    GLenum mode = GL_EYE_LINEAR;
    std::array<float, 4> object_plane{};
    std::array<float, 4> eye_plane{};
};

struct TextureUnit {
    std::array<std::shared_ptr<TextureObject>, TextureTargets> bound; // never null
    std::array<bool, TextureTargets> enabled{};
    TextureEnvironment environment;
    std::array<TexGen, 4> gen = initial_gen(); // s t r q

    static std::array<TexGen, 4> initial_gen() {
        std::array<TexGen, 4> gen;
        gen[0].object_plane = gen[0].eye_plane = {1, 0, 0, 0};
        gen[1].object_plane = gen[1].eye_plane = {0, 1, 0, 0};
        return gen;
    }
};

struct TextureState {
    TextureState(); // Makes the default textures (name 0), which each context has of its own.

    GLuint active_unit = 0;
    std::array<TextureUnit, TextureUnits> units;
    std::array<std::shared_ptr<TextureObject>, TextureTargets> defaults;
    std::array<std::shared_ptr<TextureObject>, TextureTargets> proxies; // in no attribute group

    TextureUnit& active() { return units[active_unit]; }
    const TextureUnit& active() const { return units[active_unit]; }
};

} // namespace ffgpu::gl
