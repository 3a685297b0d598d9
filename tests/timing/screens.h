// Screens of one depth and one colour on a machine that follows values: what closed forms tell of.

#pragma once

#include "tests/gpu/scene.h"
#include "tests/timing/values_bench.h"

namespace ffgpu::timing {

inline constexpr int Size = 64;

class Screens {
public:
    explicit Screens(const TimingConfig& config)
        : bench(config)
        , assembler_(bench)
        , scene(Size, Size) {
        scene.registers.depth = {.test_enable = true, .write_enable = true};
        scene.gpu.set_work_sink(&assembler_, WorkDetail::Values);
    }
    ~Screens() { scene.gpu.set_work_sink(nullptr); }

    // All pixels at this depth, from -1 to 1.
    void screen(float z, float alpha = 1) {
        const auto corner = [&](float x, float y) {
            return test::Vertex{x, y, z, 1, 1, 1, 1, alpha, 0, 0};
        };
        // One triangle: no block is visited twice.
        scene.draw(PrimitiveType::Triangles, {corner(-1, -1), corner(3, -1), corner(-1, 3)});
    }
    Figures end() {
        CommandStream stream;
        stream.add(Opcode::EndFrame);
        scene.gpu.submit(stream);
        return bench.figures();
    }

    ValuesBench bench;

private:
    work::CommandAssembler assembler_;

public:
    test::Scene scene;
};

inline TimingConfig small_caches() {
    TimingConfig config;
    config.depth_cache.sets = config.color_cache.sets = 4;
    return config;
}

} // namespace ffgpu::timing
