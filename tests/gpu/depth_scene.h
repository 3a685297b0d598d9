// Seeded random work on a depth target: all that changes what it holds, and how it is tested.

#pragma once

#include "tests/gpu/scene.h"

#include <algorithm>
#include <random>
#include <vector>

namespace ffgpu::test {

struct DepthSceneKind {
    Format depth = Format::Depth24Stencil8;
    Format color = Format::Rgba8;
    std::uint8_t samples = 1;
};

class DepthScene {
public:
    static constexpr int Width = 74, Height = 54; // no whole blocks

    DepthScene(std::uint32_t seed, const DepthSceneKind& kind, FunctionalGpu::Config config = {})
        : scene(Width, Height, config)
        , random_(seed)
        , kind_(kind) {
        Targets& targets = scene.registers.targets;
        targets.depth.format = kind.depth;
        targets.depth.stride = Width * format_info(kind.depth).block_bytes;
        targets.color[0].format = kind.color;
        targets.color[0].stride = Width * format_info(kind.color).block_bytes;
        targets.color[0].samples = targets.depth.samples = kind.samples;
        scene.registers.multisample.enable = kind.samples > 1;
    }

    // `clear_all`: begins with a clear of everything.
    void frame(int commands, bool clear_all = true) {
        if (clear_all) clear(true);
        for (int i = 0; i < commands; ++i)
            step();
        scene.registers.scissor = {0, 0, Width, Height};
        CommandStream stream;
        stream.add(Opcode::EndFrame);
        scene.gpu.submit(stream);
    }

    Scene scene;

private:
    std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    std::uint32_t below(std::uint32_t n) { return word() % n; }
    bool one_in(std::uint32_t n) { return below(n) == 0; }
    float unit() { return static_cast<float>(random_() & 0xffff) / 32768.0f - 1.0f; }
    std::uint32_t most_depth() const {
        return kind_.depth == Format::Depth16 ? 0xffffu : 0xffffffu;
    }

    void step() {
        switch (below(16)) {
        case 0:
            return clear(false);
        case 1:
            return host_write();
        case 2:
            return host_read();
        case 3:
            return copy();
        case 4:
            return image();
        default:
            return draw();
        }
    }

    void scissor(bool all) {
        if (all || one_in(2)) {
            scene.registers.scissor = {0, 0, Width, Height};
            return;
        }
        const std::uint32_t x = below(Width - 1), y = below(Height - 1);
        scene.registers.scissor = {static_cast<std::int16_t>(x),
                                   static_cast<std::int16_t>(y),
                                   static_cast<std::uint16_t>(1 + below(Width - x)),
                                   static_cast<std::uint16_t>(1 + below(Height - y))};
    }

    void clear(bool all) {
        scissor(all);
        ClearCommand clear;
        clear.depth = all || one_in(2);
        clear.stencil = all || one_in(3);
        clear.color = all || one_in(3);
        clear.depth_value = one_in(2) ? most_depth() : word() & most_depth();
        clear.stencil_value = static_cast<std::uint8_t>(below(4));
        clear.color_value = one_in(2) ? 0 : word();
        scene.registers.stencil.front.write_mask = all || one_in(2) ? 0xff : 0x0f;
        scene.registers.blend.write_mask = all || one_in(2) ? 0xf : 0x7;
        scene.command(clear);
    }

    void host_write() {
        const Targets& targets = scene.registers.targets;
        const Surface& surface = one_in(2) ? targets.depth : targets.color[0];
        std::vector<std::uint32_t> words(1 + below(300));
        std::generate(words.begin(), words.end(), [this] { return word(); });
        const auto at = static_cast<DeviceAddress>(
            surface.address + below(static_cast<std::uint32_t>(surface.bytes() - 1200)));
        scene.gpu.write_memory(at, bytes_of(words));
    }

    void host_read() {
        std::vector<std::byte> bytes(700);
        scene.gpu.read_memory(scene.registers.targets.depth.address + 100, bytes);
    }

    void copy() {
        const Surface& surface = scene.registers.targets.depth;
        scene.command(CopyRectangleCommand{.source = surface,
                                           .destination = surface,
                                           .source_x = static_cast<std::uint16_t>(below(20)),
                                           .source_y = 3,
                                           .destination_x = static_cast<std::uint16_t>(below(30)),
                                           .destination_y = 20,
                                           .width = 30,
                                           .height = 17});
    }

    void image() {
        const bool stencil = kind_.depth == Format::Depth24Stencil8 && one_in(2);
        std::vector<std::uint32_t> pixels(16 * 16, word());
        scene.gpu.write_memory(TextureAt + 0x100000, bytes_of(pixels));
        random_state();
        scene.command(DrawImageCommand{.format = stencil ? Format::Stencil8 : Format::Rgba8,
                                       .address = TextureAt + 0x100000,
                                       .stride = stencil ? 16u : 64u,
                                       .width = 16,
                                       .height = 16,
                                       .x = 3.3f + static_cast<float>(below(30)),
                                       .y = 5.6f,
                                       .zoom_x = 1.4f,
                                       .zoom_y = 0.7f,
                                       .depth = 0.5f + 0.5f * unit()});
    }

    StencilFace random_face() {
        return {.compare = static_cast<Compare>(below(8)),
                .fail = static_cast<StencilOp>(below(8)),
                .depth_fail = static_cast<StencilOp>(below(8)),
                .depth_pass = static_cast<StencilOp>(below(8)),
                .reference = static_cast<std::uint8_t>(below(4)),
                .write_mask = one_in(2) ? std::uint8_t{0xff} : std::uint8_t{0x33}};
    }

    void random_state() {
        Registers& r = scene.registers;
        scissor(false);
        r.depth.test_enable = !one_in(8);
        r.depth.write_enable = r.depth.test_enable && !one_in(4);
        r.depth.compare = one_in(2) ? Compare::Less : static_cast<Compare>(below(8));
        r.depth.bounds_enable = one_in(8);
        r.depth.bounds_min = most_depth() / 4;
        r.depth.bounds_max = most_depth() / 4 * 3;
        r.stencil.enable = one_in(4);
        r.stencil.front = random_face();
        r.stencil.back = random_face();
        r.fragment.alpha_test = one_in(3);
        r.fragment.alpha_compare = Compare::Greater;
        r.fragment.alpha_reference = 100;
        r.multisample.alpha_to_coverage = one_in(4);
        r.multisample.sample_mask = one_in(3) ? 0x5 : 0xf;
        r.multisample.enable = kind_.samples > 1 && !one_in(4);
        r.primitive.offset_fill = one_in(3);
        r.primitive.offset_factor = 2 * unit();
        r.primitive.offset_units = 100 * unit();
        r.blend.enable = one_in(3);
        r.blend.rgb_source = BlendFactor::SourceAlpha;
        r.blend.rgb_destination = BlendFactor::OneMinusSourceAlpha;
        r.blend.write_mask = one_in(4) ? 0x7 : 0xf;
        r.viewport.near_depth = one_in(2) ? 0.0f : 0.3f;
        r.viewport.far_depth = one_in(2) ? 1.0f : 0.2f;
    }

    void draw() {
        random_state();
        const float size = one_in(2) ? 1.5f : 0.3f;
        const float flat = one_in(2) ? 0.02f : 0.8f; // of one depth, about, or across all
        std::vector<Vertex> vertices;
        for (unsigned triangle = 0; triangle < 1 + below(4); ++triangle) {
            const float x = unit(), y = unit(), z = unit() * 0.9f;
            for (int i = 0; i < 3; ++i) {
                const float w = 1.5f + unit();
                vertices.push_back({(x + size * unit()) * w,
                                    (y + size * unit()) * w,
                                    (z + flat * unit()) * w,
                                    w,
                                    0.5f + 0.5f * unit(),
                                    0.5f,
                                    0.5f + 0.5f * unit(),
                                    0.5f + 0.5f * unit(),
                                    unit() * 4,
                                    unit() * 4});
            }
        }
        scene.draw(PrimitiveType::Triangles, vertices);
    }

    std::mt19937 random_;
    DepthSceneKind kind_;
};

} // namespace ffgpu::test
