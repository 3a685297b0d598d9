// The register map: every register of the device, once. A register's address is its place in
// this list; the command stream, the reset state, docs/registers.md and the SystemVerilog package
// loop over it.

#pragma once

#include "model/device/layout/register.h"
#include "model/device/registers/fragment.h"
#include "model/device/registers/geometry.h"
#include "model/device/registers/primitive.h"
#include "model/device/registers/texture.h"
#include "model/device/registers/vertex.h"

#include <array>
#include <cstdint>

namespace ffgpu {

struct Registers {
    VertexFormat vertex_format;
    CurrentAttributes current;
    Transform transform;
    Lighting lighting;
    std::array<Light, Lights> lights;
    std::array<Material, 2> materials;
    std::array<TexCoordSetup, TextureUnits> tex_coords;
    UserClipPlanes clip_planes;
    Viewport viewport;
    PrimitiveSetup primitive;
    PolygonStipple polygon_stipple;
    Scissor scissor;
    std::array<TextureImage, TextureUnits> images;
    std::array<Sampler, TextureUnits> samplers;
    std::array<Combiner, TextureUnits> combiners;
    Fog fog;
    FragmentControl fragment;
    Stencil stencil;
    DepthControl depth;
    Blend blend;
    Multisample multisample;
    Targets targets;

    // Calls visitor(register) for each, in the order of addresses.
    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& visitor) {
        const auto each = [&](auto& array) {
            for (auto& reg : array)
                visitor(reg);
        };
        visitor(self.vertex_format);
        visitor(self.current);
        visitor(self.transform);
        visitor(self.lighting);
        each(self.lights);
        each(self.materials);
        each(self.tex_coords);
        visitor(self.clip_planes);
        visitor(self.viewport);
        visitor(self.primitive);
        visitor(self.polygon_stipple);
        visitor(self.scissor);
        each(self.images);
        each(self.samplers);
        each(self.combiners);
        visitor(self.fog);
        visitor(self.fragment);
        visitor(self.stencil);
        visitor(self.depth);
        visitor(self.blend);
        visitor(self.multisample);
        visitor(self.targets);
    }
    bool operator==(const Registers&) const = default;
};

constexpr unsigned count_registers() {
    Registers registers{};
    unsigned count = 0;
    Registers::visit(registers, [&](auto&) { ++count; });
    return count;
}
constexpr unsigned RegisterCount = count_registers();

// Words of the register at each address.
constexpr std::array<std::uint8_t, RegisterCount> RegisterWords = [] {
    std::array<std::uint8_t, RegisterCount> words{};
    Registers registers{};
    std::size_t address = 0;
    Registers::visit(registers, [&](auto& reg) {
        words[address++] = WordCount<std::remove_cvref_t<decltype(reg)>>;
    });
    return words;
}();

// The address of a register; of an array of registers, its first's.
template <auto Member>
consteval std::uint32_t find_register_address() {
    const Registers registers{};
    const void* wanted = &(registers.*Member);
    std::uint32_t address = 0, found = RegisterCount;
    Registers::visit(registers, [&](const auto& reg) {
        if (static_cast<const void*>(&reg) == wanted) found = address;
        ++address;
    });
    return found;
}

} // namespace ffgpu
