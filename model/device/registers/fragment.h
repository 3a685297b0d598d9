// Registers of the fragment stages after texturing, in the order of the pipe.

#pragma once

#include "model/device/layout/formats.h"
#include "model/device/layout/register.h"
#include "model/device/registers/geometry.h"
#include "model/device/registers/texture.h"

#include <array>
#include <cstdint>

namespace ffgpu {

enum class FogMode : std::uint8_t { Off, Linear, Exp, Exp2 };

struct Fog {
    static constexpr const char* Name = "fog";

    FogMode mode = FogMode::Off;
    FogCoordinateSource source = FogCoordinateSource::EyeZ;
    std::uint32_t color = 0; // rgb8, red in the lowest byte
    float density = 1;
    float start = 0;
    float end = 1;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("mode", self.mode, 2);
        field("source", self.source, 2);
        field("color", self.color, 24);
        field("density", self.density);
        field("start", self.start);
        field("end", self.end);
    }
    bool operator==(const Fog&) const = default;
};

// Colour sum, alpha test, dither, sRGB encoding.
struct FragmentControl {
    static constexpr const char* Name = "fragment_control";

    bool color_sum = false;
    bool alpha_test = false;
    Compare alpha_compare = Compare::Always;
    std::uint8_t alpha_reference = 0; // 0 to 255
    bool dither = true;               // Only targets of less than 8 bits a channel are dithered.
    bool count_samples = false;       // Fragments that pass add to the occlusion counter.
    // A bit for each colour target whose red, green and blue are sRGB codes: they are blended as
    // light, encoded when they are written, and know no logic operation (EXT_framebuffer_sRGB).
    std::uint8_t srgb_targets = 0;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("color_sum", self.color_sum, 1);
        field("alpha_test", self.alpha_test, 1);
        field("alpha_compare", self.alpha_compare, 3);
        field("alpha_reference", self.alpha_reference, 8);
        field("dither", self.dither, 1);
        field("count_samples", self.count_samples, 1);
        field("srgb_targets", self.srgb_targets, ColorTargets);
    }
    constexpr bool is_srgb(unsigned target) const { return (srgb_targets >> target & 1) != 0; }
    bool operator==(const FragmentControl&) const = default;
};

enum class StencilOp : std::uint8_t {
    Keep,
    Zero,
    Replace,
    Increment, // saturates
    Decrement,
    Invert,
    IncrementWrap,
    DecrementWrap,
};

struct StencilFace {
    Compare compare = Compare::Always;
    StencilOp fail = StencilOp::Keep;
    StencilOp depth_fail = StencilOp::Keep;
    StencilOp depth_pass = StencilOp::Keep;
    std::uint8_t reference = 0;
    std::uint8_t compare_mask = 0xff;
    std::uint8_t write_mask = 0xff;

    bool operator==(const StencilFace&) const = default;
};

struct Stencil {
    static constexpr const char* Name = "stencil";

    bool enable = false;
    StencilFace front, back; // The driver writes both alike where two-sided stencil is off.

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        const auto visit_face = [&](const char* part, auto& face) {
            const auto face_field = in_part(part, field);
            face_field("compare", face.compare, 3);
            face_field("fail", face.fail, 3);
            face_field("depth_fail", face.depth_fail, 3);
            face_field("depth_pass", face.depth_pass, 3);
            face_field("reference", face.reference, 8);
            face_field("compare_mask", face.compare_mask, 8);
            face_field("write_mask", face.write_mask, 8);
        };
        visit_face("front", self.front);
        visit_face("back", self.back);
    }
    bool operator==(const Stencil&) const = default;
};

struct DepthControl {
    static constexpr const char* Name = "depth_control";

    bool test_enable = false;
    bool write_enable = false; // Only together with test_enable (GL 1.5, 4.1.6).
    Compare compare = Compare::Less;
    bool bounds_enable = false; // EXT_depth_bounds_test, on the stored depth
    std::uint32_t bounds_min = 0;
    std::uint32_t bounds_max = 0xffffff;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("test_enable", self.test_enable, 1);
        field("write_enable", self.write_enable, 1);
        field("compare", self.compare, 3);
        field("bounds_enable", self.bounds_enable, 1);
        field("bounds_min", self.bounds_min, 24);
        field("bounds_max", self.bounds_max, 24);
    }
    bool operator==(const DepthControl&) const = default;
};

enum class BlendFactor : std::uint8_t {
    Zero,
    One,
    SourceColor,
    OneMinusSourceColor,
    DestinationColor,
    OneMinusDestinationColor,
    SourceAlpha,
    OneMinusSourceAlpha,
    DestinationAlpha,
    OneMinusDestinationAlpha,
    ConstantColor,
    OneMinusConstantColor,
    ConstantAlpha,
    OneMinusConstantAlpha,
    SourceAlphaSaturate,
};

enum class BlendEquation : std::uint8_t { Add, Subtract, ReverseSubtract, Min, Max };

// In OpenGL's order, GL_CLEAR to GL_SET.
enum class LogicOp : std::uint8_t {
    Clear,
    And,
    AndReverse,
    Copy,
    AndInverted,
    Noop,
    Xor,
    Or,
    Nor,
    Equiv,
    Invert,
    OrReverse,
    CopyInverted,
    OrInverted,
    Nand,
    Set,
};

struct Blend {
    static constexpr const char* Name = "blend";

    bool enable = false;
    bool logic_op_enable = false; // Takes the place of blending.
    LogicOp logic_op = LogicOp::Copy;
    BlendEquation rgb_equation = BlendEquation::Add;
    BlendEquation alpha_equation = BlendEquation::Add;
    BlendFactor rgb_source = BlendFactor::One;
    BlendFactor rgb_destination = BlendFactor::Zero;
    BlendFactor alpha_source = BlendFactor::One;
    BlendFactor alpha_destination = BlendFactor::Zero;
    std::uint32_t constant = 0;    // rgba8, red in the lowest byte
    std::uint8_t write_mask = 0xf; // bit 0 red .. bit 3 alpha

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        field("logic_op_enable", self.logic_op_enable, 1);
        field("logic_op", self.logic_op, 4);
        field("rgb_equation", self.rgb_equation, 3);
        field("alpha_equation", self.alpha_equation, 3);
        field("rgb_source", self.rgb_source, 4);
        field("rgb_destination", self.rgb_destination, 4);
        field("alpha_source", self.alpha_source, 4);
        field("alpha_destination", self.alpha_destination, 4);
        field("write_mask", self.write_mask, 4);
        field("constant", self.constant, 32);
    }
    bool operator==(const Blend&) const = default;
};

// Samples of multisampled targets (GL 1.5, 4.1.3 and 4.1.10 to 4.1.11). Of no effect where the
// targets have one sample a pixel.
struct Multisample {
    static constexpr const char* Name = "multisample";

    // Primitives cover samples, not pixels: on by GL_MULTISAMPLE. Off: a pixel's samples are
    // covered together, by the rules of single-sampled targets.
    bool enable = false;
    bool alpha_to_coverage = false;
    bool alpha_to_one = false;
    std::uint8_t sample_mask = 0xf; // one bit a sample: those that GL_SAMPLE_COVERAGE lets through

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("enable", self.enable, 1);
        field("alpha_to_coverage", self.alpha_to_coverage, 1);
        field("alpha_to_one", self.alpha_to_one, 1);
        field("sample_mask", self.sample_mask, 4);
    }
    bool operator==(const Multisample&) const = default;
};

// A colour target (any uncompressed colour format) or a depth target (Depth16, Depth24Stencil8).
// Format None: there is none; its stages do nothing. Row y begins at address + y * stride.
//
// A multisampled surface is `samples` such planes one behind the other, stride * height bytes
// apart: plane i holds sample i of every pixel.
struct Surface {
    static constexpr const char* Name = "surface";

    DeviceAddress address = 0;
    Format format = Format::None;
    std::uint16_t width = 0, height = 0;
    std::uint32_t stride = 0; // bytes
    std::uint8_t samples = 1; // 1 or MaxSamples

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("address", self.address, 32);
        field("format", self.format, 5);
        field("width", self.width, 13);
        field("height", self.height, 13);
        field("stride", self.stride, 32);
        field("samples", self.samples, 3);
    }
    bool operator==(const Surface&) const = default;

    std::uint64_t plane_bytes() const { return std::uint64_t{stride} * height; }
    std::uint64_t bytes() const { return plane_bytes() * samples; }

    // Sample i of every pixel as a surface of its own.
    Surface plane(unsigned i) const {
        Surface one = *this;
        one.address = static_cast<DeviceAddress>(address + i * plane_bytes());
        one.samples = 1;
        return one;
    }
};

// What a draw writes: each colour target gets every fragment, blended with what it holds. Those in
// use have the same number of samples, and so has the depth target.
struct Targets {
    static constexpr const char* Name = "targets";

    std::array<Surface, ColorTargets> color;
    Surface depth;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        for (auto& surface : self.color)
            Surface::visit(surface, in_part("color", field));
        Surface::visit(self.depth, in_part("depth", field));
    }
    bool operator==(const Targets&) const = default;

    // Of a pixel; 1 without targets.
    unsigned samples() const {
        unsigned most = 1;
        for_each(*this, [&most](const Surface& surface) {
            if (surface.format != Format::None && surface.samples > most) most = surface.samples;
        });
        return most;
    }

    // Calls visitor(surface) for each target, those of Format::None too.
    template <class Self, class Visitor>
    static constexpr void for_each(Self& self, Visitor&& visitor) {
        for (auto& surface : self.color)
            visitor(surface);
        visitor(self.depth);
    }
};

} // namespace ffgpu
