// one_quad_draws FILE.ffc: a capture of draws of one quad each, in which every unit of the fragment
// pipe has a part. Prints the draws' names: number k stands at quad 2 k, 0, and all its lanes live.
// What a fault is to be named by follows from this file and from the fault.

#include "model/capture/capture_writer.h"
#include "tests/gpu/scene.h"

#include <cstdio>
#include <functional>

namespace ffgpu::test {
namespace {

constexpr DeviceAddress NarrowAt = 0x600000;
constexpr std::uint16_t Width = 256, Height = 8;

// A triangle of eight pixels, of which the scissor leaves the quad in its lower left corner: a
// colour that changes by some twenty codes a pixel, coordinates over `texels` texels of 1 / 64 a
// pixel.
struct Shape {
    float near_w = 1, texels = 1, stretch = 1;
    float depth = -0.2f, rise = 0.5f; // at the corner, and from there on
    float inset = 0;                  // of the corner, of the quad's side
};

std::vector<Vertex> triangle(const Shape& shape) {
    const float s = shape.texels * shape.stretch / 8, t = shape.texels / 8, w = shape.near_w;
    const float z = shape.depth, low = shape.inset / 2 - 1;
    return {{low * w, low * w, z * w, w, 0.3f, 0.4f, 0.2f, 0.6f, 0.02f, 0.03f},
            {1, low, z + 1.2f * shape.rise, 1, 0.9f, 0.5f, 0.7f, 0.8f, 0.02f + s, 0.03f},
            {low, 1, z + shape.rise, 1, 0.5f, 0.9f, 0.4f, 0.4f, 0.02f, 0.03f + t}};
}

class Draws {
public:
    explicit Draws(const std::string& path)
        : scene_(Width, Height)
        , writer_(scene_.gpu) {
        writer_.begin(path, 0);
        scene_.into = &writer_;
        fill_memory();
        scene_.clear(0xa0604020);
        plain_ = scene_.registers;
    }
    ~Draws() {
        writer_.finish();
        writer_.frame_shown(0, scene_.registers.targets.color[0]);
        writer_.end();
    }

    // The registers as they are told, in a draw that stands by itself.
    void add(const char* name, const std::function<void(Registers&)>& change, Shape shape = {}) {
        Registers& registers = scene_.registers = plain_;
        const auto x = static_cast<std::int16_t>(2 * count_++);
        registers.scissor = {x, 0, 2, 2};
        registers.viewport.x = x;
        registers.viewport.width = registers.viewport.height = 8;
        change(registers);
        scene_.draw(PrimitiveType::Triangles, triangle(shape));
        std::puts(name);
    }

    // Colours without a rule, or blocks; 64 by 64 with all levels.
    static void texture(Registers& registers, Format format = Format::Rgba8) {
        registers.images[0].shape = {TextureKind::TwoD, format, 64, 64, 1, 7, 0};
        registers.images[0].address = TextureAt;
        registers.samplers[0].magnify_linear = registers.samplers[0].minify_linear = false;
        registers.samplers[0].mip_filter = MipFilter::None;
        registers.combiners[0].enable = true;
        registers.combiners[0].rgb.arguments[0] = {CombineSource::Texture0, CombineOperand::Color};
        registers.combiners[0].alpha.arguments[0] = {CombineSource::Texture0,
                                                     CombineOperand::Alpha};
    }
    static void narrow(Registers& registers) {
        registers.targets.color[0] = {NarrowAt, Format::Rgb565, Width, Height, 2 * Width};
    }

private:
    void fill_memory() {
        std::vector<std::uint32_t> texels;
        for (std::uint32_t i = 0; i < 8192; ++i)
            texels.push_back((i + 1) * 0x9e3779b1u ^ 0x9c3e51a7u);
        writer_.write_memory(TextureAt, bytes_of(texels));
    }

    Scene scene_;
    capture::CaptureWriter writer_;
    Registers plain_;
    unsigned count_ = 0;
};

CombineArgument from(CombineSource source) {
    return {source, CombineOperand::Color};
}

void add_targets(Draws& draws) {
    draws.add("plain", [](Registers&) {});
    draws.add("plain, other bank", [](Registers&) {});
    draws.add("perspective", [](Registers&) {}, {.near_w = 2});
    draws.add("depth", [](Registers& r) {
        r.depth = {.test_enable = true, .write_enable = true, .compare = Compare::Lequal};
    });
    // The first pixel's centre lies before the triangle, whose corner has the least or greatest
    // depth.
    const auto beside = [](Registers& r) {
        r.depth.test_enable = true;
        r.depth.compare = Compare::Always;
        r.primitive.polygon_smooth = true;
    };
    draws.add("below", beside, {.depth = -1, .inset = 0.4f});
    draws.add("above", beside, {.depth = 1, .rise = -0.5f, .inset = 0.4f});
    draws.add("stencil", [](Registers& r) {
        r.stencil.enable = true;
        r.stencil.front.depth_pass = StencilOp::Increment;
        r.stencil.back = r.stencil.front;
    });
    draws.add("alpha", [](Registers& r) {
        r.fragment.alpha_test = true;
        r.fragment.alpha_compare = Compare::Greater;
        r.fragment.alpha_reference = 40;
    });
    draws.add("smooth", [](Registers& r) { r.primitive.polygon_smooth = true; });
    for (unsigned bank = 0; bank < 2; ++bank)
        draws.add(bank ? "color sum, other bank" : "color sum", [](Registers& r) {
            r.fragment.color_sum = true;
            r.current.values[static_cast<unsigned>(Attribute::SecondaryColor)] = {0.1f, 0.2f, 0.3f};
        });
}

void add_fog(Draws& draws) {
    for (unsigned bank = 0; bank < 2; ++bank)
        for (const auto& [name, mode] : {std::pair{"linear", FogMode::Linear},
                                         {"exponential", FogMode::Exp},
                                         {"squared", FogMode::Exp2}})
            draws.add((std::string("fog ") + name + (bank ? ", other bank" : "")).c_str(),
                      [mode = mode](Registers& r) {
                          r.fog = {.mode = mode, .color = 0x2080ff, .density = 0.7f, .end = 3};
                          r.fog.source = FogCoordinateSource::Attribute;
                          r.current.values[static_cast<unsigned>(Attribute::FogCoordinate)] = {
                              0.9f};
                      });
}

void add_blending(Draws& draws) {
    for (unsigned factor = 0; factor < 15; ++factor)
        draws.add(("factor " + std::to_string(factor)).c_str(), [&](Registers& r) {
            r.blend.enable = true;
            r.blend.rgb_source = static_cast<BlendFactor>(factor);
            r.blend.rgb_destination = BlendFactor::One;
            r.blend.constant = 0x90406080;
        });
    for (unsigned equation = 1; equation < 5; ++equation)
        draws.add(("equation " + std::to_string(equation)).c_str(), [&](Registers& r) {
            r.blend.enable = true;
            r.blend.rgb_equation = static_cast<BlendEquation>(equation);
            r.blend.rgb_destination = BlendFactor::One;
        });
    for (unsigned operation = 0; operation < 16; ++operation)
        draws.add(("logic " + std::to_string(operation)).c_str(), [&](Registers& r) {
            r.blend.logic_op_enable = true;
            r.blend.logic_op = static_cast<LogicOp>(operation);
        });
    draws.add("narrow", [](Registers& r) {
        Draws::narrow(r);
        r.fragment.dither = false;
    });
    draws.add("dithered", [](Registers& r) { Draws::narrow(r); });
    draws.add("narrow, blended", [](Registers& r) {
        Draws::narrow(r);
        r.blend.enable = true;
        r.blend.rgb_destination = BlendFactor::DestinationColor;
    });
}

void add_textures(Draws& draws) {
    const auto plain = [](Registers& r) { Draws::texture(r); };
    draws.add("nearest", plain);
    draws.add("nearest, other bank", plain);
    draws.add("linear", [](Registers& r) {
        Draws::texture(r);
        r.samplers[0].magnify_linear = r.samplers[0].minify_linear = true;
    });
    for (unsigned bank = 0; bank < 2; ++bank)
        draws.add(bank ? "mipmaps, other bank" : "mipmaps",
                  [](Registers& r) {
                      Draws::texture(r);
                      r.samplers[0].magnify_linear = r.samplers[0].minify_linear = true;
                      r.samplers[0].mip_filter = MipFilter::Linear;
                  },
                  {.texels = 2.5f});
    draws.add("anisotropic",
              [](Registers& r) {
                  Draws::texture(r);
                  r.samplers[0].magnify_linear = r.samplers[0].minify_linear = true;
                  r.samplers[0].mip_filter = MipFilter::Linear;
                  r.samplers[0].max_anisotropy = 4;
              },
              {.texels = 2, .stretch = 3.4f});
    draws.add("mirrored",
              [](Registers& r) {
                  Draws::texture(r);
                  r.samplers[0].wrap = {Wrap::MirroredRepeat, Wrap::MirroredRepeat, Wrap::Repeat};
              },
              {.texels = 160});
    draws.add("srgb", [](Registers& r) {
        Draws::texture(r);
        r.images[0].srgb = true;
    });
    for (const auto& [name, format] :
         {std::pair{"dxt1", Format::Dxt1Rgb}, {"dxt5", Format::Dxt5}, {"fxt1", Format::Fxt1Rgba}})
        draws.add(name, [format = format](Registers& r) { Draws::texture(r, format); });
}

void add_environments(Draws& draws) {
    const auto combine = [&](const char* name, CombineOp op, std::uint8_t shift) {
        draws.add(name, [&](Registers& r) {
            Draws::texture(r);
            CombineHalf& rgb = r.combiners[0].rgb;
            rgb.op = op;
            rgb.arguments = {from(CombineSource::Primary),
                             from(CombineSource::Constant),
                             from(CombineSource::Texture0),
                             from(CombineSource::One)};
            rgb.scale_shift = shift;
            r.combiners[0].constant = 0x60d04030;
        });
    };
    combine("modulate", CombineOp::Modulate, 0);
    combine("interpolate", CombineOp::Interpolate, 0);
    combine("scaled", CombineOp::Modulate, 1);
    combine("dot product", CombineOp::Dot3Rgb, 0);
    combine("sum of products", CombineOp::AddProducts, 0);
}

} // namespace
} // namespace ffgpu::test

int main(int count, char** arguments) {
    if (count != 2) return 2;
    ffgpu::test::Draws draws(arguments[1]);
    ffgpu::test::add_targets(draws);
    ffgpu::test::add_fog(draws);
    ffgpu::test::add_blending(draws);
    ffgpu::test::add_textures(draws);
    ffgpu::test::add_environments(draws);
    return 0;
}
