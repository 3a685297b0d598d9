// Registers of a texture unit: image, sampler, environment (combiner).

#pragma once

#include "model/device/layout/formats.h"
#include "model/device/layout/limits.h"
#include "model/device/layout/register.h"
#include "model/device/layout/texture_layout.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// kind None: the unit is off and yields nothing. Levels and layout: texture_layout.h.
struct TextureImage {
    static constexpr const char* Name = "texture_image";

    TextureShape shape;
    DeviceAddress address = 0; // of level 0, a multiple of 64
    bool srgb = false;         // Texels' r, g and b are sRGB codes, read as linear light.

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("kind", self.shape.kind, 3);
        field("format", self.shape.format, 5);
        field("border", self.shape.border, 1);
        field("levels", self.shape.levels, 4);
        field("width", self.shape.width, 13);
        field("srgb", self.srgb, 1);
        field("height", self.shape.height, 13);
        field("depth", self.shape.depth, 10);
        field("address", self.address, 32);
    }
    bool operator==(const TextureImage&) const = default;
};

enum class Wrap : std::uint8_t {
    Repeat,
    MirroredRepeat,
    Clamp, // GL_CLAMP: coordinates to [0, 1]; linear filters then mix in the border
    ClampToEdge,
    ClampToBorder,
    MirrorClamp, // EXT_texture_mirror_clamp
    MirrorClampToEdge,
    MirrorClampToBorder,
};

enum class MipFilter : std::uint8_t { None, Nearest, Linear };

enum class Compare : std::uint8_t { Never, Less, Equal, Lequal, Greater, Notequal, Gequal, Always };

// What a depth texture's comparison or value D becomes, as (r, g, b, a).
enum class DepthMode : std::uint8_t {
    Luminance /*D D D 1*/,
    Intensity /*D D D D*/,
    Alpha /*0 0 0 D*/
};

// How texels become a sample (model/texture/wide_filters.h). A rip-map and a summed-area table are
// images of their own, which the driver makes from the texture's and gives in its place.
enum class TextureFilter : std::uint8_t {
    Standard,   // OpenGL's: nearest, linear, mip-mapped, anisotropic
    Bicubic,    // where it magnifies; else Standard
    RipMap,     // the image is a rip-map
    SummedArea, // the image is a summed-area table
    Elliptic,   // where it minifies; else Standard
    Feline,     // the same
};

// Level of detail values are signed, with 8 fraction bits.
struct Sampler {
    static constexpr const char* Name = "sampler";

    std::array<Wrap, 3> wrap{}; // s, t, r
    bool magnify_linear = true;
    bool minify_linear = false; // within a level
    MipFilter mip_filter = MipFilter::Linear;
    std::uint8_t base_level = 0; // Level 0 of the image is the GL's base level; kept for reports.
    std::uint8_t max_level = 12; // Clamped to image.levels - 1.
    std::int16_t bias = 0;       // Sum of the unit's and the object's, clamped to +-16.
    std::int16_t min_lod = -16 * 256;
    std::int16_t max_lod = 16 * 256;
    std::uint8_t max_anisotropy = 1; // 1 to 16
    bool compare_enable = false;
    Compare compare = Compare::Lequal;
    DepthMode depth_mode = DepthMode::Luminance;
    std::uint32_t border_color = 0; // rgba8, red in the lowest byte, as the format would read
    std::uint32_t border_depth = 0; // For depth formats: 24-bit unsigned.
    TextureFilter filter = TextureFilter::Standard;
    std::uint16_t source_width = 0; // Of the texture that a rip-map or a table was made from.
    std::uint16_t source_height = 0;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        for (auto& wrap : self.wrap)
            field("wrap", wrap, 3);
        field("magnify_linear", self.magnify_linear, 1);
        field("minify_linear", self.minify_linear, 1);
        field("mip_filter", self.mip_filter, 2);
        field("base_level", self.base_level, 4);
        field("max_level", self.max_level, 4);
        field("max_anisotropy", self.max_anisotropy, 5);
        field("compare_enable", self.compare_enable, 1);
        field("compare", self.compare, 3);
        field("depth_mode", self.depth_mode, 2);
        field("bias", self.bias, 16);
        field("min_lod", self.min_lod, 16);
        field("max_lod", self.max_lod, 16);
        field("border_color", self.border_color, 32);
        field("border_depth", self.border_depth, 24);
        field("filter", self.filter, 3);
        field("source_width", self.source_width, 13);
        field("source_height", self.source_height, 13);
    }
    bool operator==(const Sampler&) const = default;
};

enum class CombineOp : std::uint8_t {
    Replace,           // a0
    Modulate,          // a0 a1
    Add,               // a0 + a1
    AddSigned,         // a0 + a1 - 1/2
    Interpolate,       // a0 a2 + a1 (1 - a2)
    Subtract,          // a0 - a1
    Dot3Rgb,           // 4 ((a0r - 1/2)(a1r - 1/2) + ...) into r g b
    Dot3Rgba,          // into a as well, by its own scale; else the alpha combiner is ignored
    ModulateAdd,       // a0 a2 + a1           (ATI_texture_env_combine3)
    ModulateSignedAdd, // a0 a2 + a1 - 1/2
    ModulateSubtract,  // a0 a2 - a1
    AddProducts,       // a0 a1 + a2 a3        (NV_texture_env_combine4)
    AddProductsSigned, // a0 a1 + a2 a3 - 1/2
};

// How many of its arguments an operation reads.
constexpr unsigned argument_count(CombineOp op) {
    switch (op) {
    case CombineOp::Replace:
        return 1;
    case CombineOp::Interpolate:
    case CombineOp::ModulateAdd:
    case CombineOp::ModulateSignedAdd:
    case CombineOp::ModulateSubtract:
        return 3;
    case CombineOp::AddProducts:
    case CombineOp::AddProductsSigned:
        return 4;
    default:
        return 2;
    }
}

enum class CombineSource : std::uint8_t {
    Texture0, // + unit: the sample of that unit (crossbar)
    Texture1,
    Texture2,
    Texture3,
    Texture4,
    Texture5,
    Texture6,
    Texture7,
    Constant,
    Primary,
    Previous, // of unit 0: Primary
    Zero,
    One,
};

static_assert(static_cast<unsigned>(CombineSource::Constant) == TextureUnits);

enum class CombineOperand : std::uint8_t { Color, OneMinusColor, Alpha, OneMinusAlpha };

struct CombineArgument {
    CombineSource source = CombineSource::Previous;
    CombineOperand operand = CombineOperand::Color;

    bool operator==(const CombineArgument&) const = default;
};

struct CombineHalf {
    CombineOp op = CombineOp::Replace;
    std::array<CombineArgument, 4> arguments{};
    std::uint8_t scale_shift = 0; // result times 1, 2 or 4, then clamped to [0, 1]

    bool operator==(const CombineHalf&) const = default;
};

// One texture environment. All of GL's environment modes are lowered to it (driver/lower).
struct Combiner {
    static constexpr const char* Name = "combiner";

    bool enable = false;
    CombineHalf rgb;
    CombineHalf alpha;          // operands Alpha or OneMinusAlpha only
    std::uint32_t constant = 0; // rgba8, red in the lowest byte

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        const auto visit_half = [&](const char* part, auto& half) {
            const auto half_field = in_part(part, field);
            half_field("op", half.op, 4);
            half_field("scale_shift", half.scale_shift, 2);
            for (auto& argument : half.arguments) {
                half_field("source", argument.source, 4);
                half_field("operand", argument.operand, 2);
            }
        };
        visit_half("rgb", self.rgb);
        visit_half("alpha", self.alpha);
        field("constant", self.constant, 32);
    }
    bool operator==(const Combiner&) const = default;
};

} // namespace ffgpu
