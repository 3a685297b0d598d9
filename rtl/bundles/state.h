// What units are told of a draw: the words of registers, and what is made of them once a draw.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/device/registers/texture.h"
#include "model/fragment/fog.h"
#include "rtl/bundles/fields.h"

#include <cstdint>

namespace ffgpu::rtl {

// Of the alpha test and the colour sum.
struct ControlWords {
    FragmentControl control;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_register(field, "fragment_control", self.control);
    }
};

struct FogWords {
    FogCurve curve;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("mode", self.curve.mode, 2);
        field("end_coordinate", self.curve.end, 32);
        field("scale", self.curve.scale, 32);
        for (unsigned channel = 3; channel-- > 0;)
            field("color", self.curve.color[channel], 8);
    }
};

struct EnvironmentWords {
    Combiner combiner;
    std::uint8_t sampled_units = 0;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_register(field, "combiner", self.combiner);
        field("sampled_units", self.sampled_units, TextureUnits);
    }
};

struct StencilDepthWords {
    Stencil stencil;
    DepthControl depth;
    Format format = Format::None;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_register(field, "stencil", self.stencil);
        visit_register(field, "depth_control", self.depth);
        field("format", self.format, 5);
    }
};

struct BlendWords {
    Blend blend;
    FragmentControl control;
    Format format = Format::None;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_register(field, "blend", self.blend);
        visit_register(field, "fragment_control", self.control);
        field("format", self.format, 5);
    }
};

// Of one texture unit.
struct TextureWords {
    TextureImage image;
    Sampler sampler;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_register(field, "texture_image", self.image);
        visit_register(field, "sampler", self.sampler);
    }
};

} // namespace ffgpu::rtl
