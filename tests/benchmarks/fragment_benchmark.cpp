// Cost of the fragment stages for a full batch of 256 fragments: read items_per_second, or divide
// the time by 256.

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/fragment_pipe.h"
#include "tests/fragment/random_fragments.h"

#include <benchmark/benchmark.h>

namespace {

using namespace ffgpu;
using ffgpu::test::Draws;

constexpr std::uint16_t TargetSize = 512;

// Quads of a 32x8 block, row by row, as a rasterizer hands them over.
struct Bench {
    std::vector<std::byte> memory = std::vector<std::byte>(8u << 20);
    std::shared_ptr<Registers> registers = std::make_shared<Registers>();
    DrawState state;
    std::unique_ptr<FragmentBatch> batch = std::make_unique<FragmentBatch>();
    FragmentMask covered;

    explicit Bench(unsigned live_per_quad = 4) {
        Draws draws(1);
        registers->targets.color[0] = {.address = 0,
                                       .format = Format::Rgba8,
                                       .width = TargetSize,
                                       .height = TargetSize,
                                       .stride = TargetSize * 4};
        registers->targets.depth = registers->targets.color[0];
        registers->targets.depth.address = 4u << 20;
        registers->targets.depth.format = Format::Depth24Stencil8;
        registers->scissor = {.width = TargetSize, .height = TargetSize};
        batch->quad_count = BatchQuads;
        for (unsigned q = 0; q < BatchQuads; ++q) {
            batch->x[q] = static_cast<std::uint16_t>(64 + 2 * (q % 16));
            batch->y[q] = static_cast<std::uint16_t>(64 + 2 * (q / 16));
            for (unsigned i = 0; i < live_per_quad; ++i)
                covered.set(4 * q + i);
        }
        batch->front_facing.fill(~std::uint64_t{0});
        batch->depth.fill(1000);
        for (float& coordinate : batch->fog_coordinate)
            coordinate = static_cast<float>(draws.below(1000)) / 1000.0f;
        test::randomize(draws, batch->primary);
        test::randomize(draws, batch->secondary);
        test::randomize(draws, batch->color);
        for (ColorPlanes& samples : batch->texture)
            test::randomize(draws, samples);
    }

    FragmentPipe compile() {
        state.registers = registers;
        state.units = 0xff;
        return compile_fragment_pipe(state, memory);
    }
};

void count(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * BatchFragments);
}

void run_write(benchmark::State& state, Bench& bench) {
    const FragmentPipe pipe = bench.compile();
    FragmentFates fates;
    for ([[maybe_unused]] auto _ : state) {
        bench.batch->live = bench.covered;
        write(pipe, *bench.batch, fates);
        benchmark::DoNotOptimize(fates);
        benchmark::ClobberMemory();
    }
    count(state);
}

void run_shade(benchmark::State& state, Bench& bench) {
    const FragmentPipe pipe = bench.compile();
    for ([[maybe_unused]] auto _ : state) {
        shade(pipe, *bench.batch);
        benchmark::ClobberMemory();
    }
    count(state);
}

void depth_test(benchmark::State& state) {
    Bench bench(static_cast<unsigned>(state.range(0)));
    bench.registers->depth = {
        .test_enable = true, .write_enable = true, .compare = Compare::Gequal};
    bench.registers->blend.write_mask = 0;
    run_write(state, bench);
}
BENCHMARK(depth_test)->Arg(4)->Arg(3);

void stencil_and_depth_test(benchmark::State& state) {
    Bench bench;
    bench.registers->depth = {
        .test_enable = true, .write_enable = true, .compare = Compare::Gequal};
    bench.registers->stencil.enable = true;
    bench.registers->stencil.front.depth_pass = StencilOp::IncrementWrap;
    bench.registers->blend.write_mask = 0;
    run_write(state, bench);
}
BENCHMARK(stencil_and_depth_test);

void alpha_test(benchmark::State& state) {
    Bench bench;
    bench.registers->fragment.alpha_test = true;
    bench.registers->fragment.alpha_compare = Compare::Greater;
    bench.registers->blend.write_mask = 0;
    run_write(state, bench);
}
BENCHMARK(alpha_test);

void opaque_store(benchmark::State& state) {
    Bench bench(static_cast<unsigned>(state.range(0)));
    run_write(state, bench);
}
BENCHMARK(opaque_store)->Arg(4)->Arg(3);

void blend_factors(benchmark::State& state, BlendFactor source, BlendFactor destination) {
    Bench bench;
    Blend& blend = bench.registers->blend;
    blend.enable = true;
    blend.rgb_source = blend.alpha_source = source;
    blend.rgb_destination = blend.alpha_destination = destination;
    run_write(state, bench);
}
BENCHMARK_CAPTURE(blend_factors,
                  translucent,
                  BlendFactor::SourceAlpha,
                  BlendFactor::OneMinusSourceAlpha);
BENCHMARK_CAPTURE(blend_factors, additive, BlendFactor::One, BlendFactor::One);
BENCHMARK_CAPTURE(blend_factors, light_map, BlendFactor::DestinationColor, BlendFactor::Zero);
BENCHMARK_CAPTURE(blend_factors,
                  general,
                  BlendFactor::SourceAlphaSaturate,
                  BlendFactor::OneMinusDestinationAlpha);

Combiner combiner(CombineOp op) {
    Combiner combiner;
    combiner.enable = true;
    combiner.rgb.op = combiner.alpha.op = op;
    for (CombineHalf* half : {&combiner.rgb, &combiner.alpha}) {
        half->arguments[0].source = CombineSource::Texture0;
        half->arguments[2].source = CombineSource::Constant;
    }
    for (CombineArgument& argument : combiner.alpha.arguments)
        argument.operand = CombineOperand::Alpha;
    return combiner;
}

void environment(benchmark::State& state, CombineOp op) {
    Bench bench;
    bench.registers->combiners[0] = combiner(op);
    run_shade(state, bench);
}
BENCHMARK_CAPTURE(environment, replace, CombineOp::Replace);
BENCHMARK_CAPTURE(environment, modulate, CombineOp::Modulate);
BENCHMARK_CAPTURE(environment, add, CombineOp::Add);
BENCHMARK_CAPTURE(environment, interpolate, CombineOp::Interpolate);
BENCHMARK_CAPTURE(environment, modulate_signed_add, CombineOp::ModulateSignedAdd);
BENCHMARK_CAPTURE(environment, dot3, CombineOp::Dot3Rgb);

void no_environment(benchmark::State& state) {
    Bench bench;
    run_shade(state, bench);
}
BENCHMARK(no_environment);

void fog(benchmark::State& state, FogMode mode) {
    Bench bench;
    const FogCurve curve = compile_fog({.mode = mode, .density = 2});
    for ([[maybe_unused]] auto _ : state) {
        apply_fog(curve, *bench.batch);
        benchmark::ClobberMemory();
    }
    count(state);
}
BENCHMARK_CAPTURE(fog, linear, FogMode::Linear);
BENCHMARK_CAPTURE(fog, exp, FogMode::Exp);
BENCHMARK_CAPTURE(fog, exp2, FogMode::Exp2);

void color_sum(benchmark::State& state) {
    Bench bench;
    for ([[maybe_unused]] auto _ : state) {
        add_secondary(*bench.batch);
        benchmark::ClobberMemory();
    }
    count(state);
}
BENCHMARK(color_sum);

void compile(benchmark::State& state) {
    Bench bench;
    bench.registers->combiners[0] = combiner(CombineOp::Modulate);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(bench.compile());
}
BENCHMARK(compile);

} // namespace
