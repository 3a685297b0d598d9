// Which groups of state changed since they were last lowered to registers. A command that changes
// state marks its group; prepare_draw() lowers the marked groups only.

#pragma once

#include <cstdint>

namespace ffgpu::gl {

enum class Dirty : std::uint32_t {
    Current = 1u << 0,  // current attributes
    Matrices = 1u << 1, // model-view and projection, normalisation
    TextureMatrices = 1u << 2,
    Lighting = 1u << 3, // light model, lights, materials
    ClipPlanes = 1u << 4,
    Viewport = 1u << 5,     // viewport, depth range, scissor
    Primitive = 1u << 6,    // points, lines, polygons, stipple
    Textures = 1u << 7,     // bindings, images, samplers, enables
    Environments = 1u << 8, // texture environments (depend on Textures too)
    TexGen = 1u << 9,
    Fragment = 1u << 10, // fog, samples, alpha, stencil, depth, blend, logic op, masks
    Targets = 1u << 11,  // drawable, framebuffer object, draw buffer
};

class DirtyGroups {
public:
    static constexpr DirtyGroups all() {
        DirtyGroups groups;
        groups.bits_ = 0xfff;
        return groups;
    }

    constexpr void mark(Dirty group) { bits_ |= static_cast<std::uint32_t>(group); }
    constexpr void mark(DirtyGroups groups) { bits_ |= groups.bits_; }
    constexpr bool has(Dirty group) const {
        return (bits_ & static_cast<std::uint32_t>(group)) != 0;
    }
    constexpr void clear() { bits_ = 0; }
    constexpr bool operator==(const DirtyGroups&) const = default;

private:
    std::uint32_t bits_ = 0;
};

} // namespace ffgpu::gl
