// Every one of the 2^24 inputs of rtl/texture_lerp.sv against the model's lerp, with and without
// back pressure.

#include "Vtexture_lerp.h"
#include "model/texture/filter.h"

#include <cstdint>
#include <memory>

#include <catch2/catch.hpp>
#include <verilated.h>

namespace ffgpu {
namespace {

class Bench {
public:
    Bench() {
        context_->randSeed(1);
        dut_ = std::make_unique<Vtexture_lerp>(context_.get());
        dut_->rst_ni = 0;
        dut_->out_ready_i = 1;
        step();
        dut_->rst_ni = 1;
    }

    Vtexture_lerp& dut() { return *dut_; }

    void step() {
        for (const int level : {1, 0}) {
            dut_->clk_i = static_cast<CData>(level);
            dut_->eval();
            context_->timeInc(1);
        }
    }

private:
    std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
    std::unique_ptr<Vtexture_lerp> dut_;
};

unsigned expected(std::uint32_t n) {
    return lerp8w(n & 0xff, (n >> 8) & 0xff, n >> 16);
}

TEST_CASE("the RTL lerp equals the model's on every input") {
    constexpr std::uint32_t Inputs = 1u << 24;
    constexpr std::uint32_t Latency = 2;
    Bench bench;
    std::uint32_t compared = 0, mismatches = 0;
    for (std::uint32_t n = 0; n < Inputs + Latency; ++n) {
        bench.dut().in_valid_i = n < Inputs;
        bench.dut().in_a_i = static_cast<CData>(n);
        bench.dut().in_b_i = static_cast<CData>(n >> 8);
        bench.dut().in_weight_i = static_cast<CData>(n >> 16);
        bench.step();
        if (n + 1 < Latency || !bench.dut().out_valid_o) continue;
        mismatches += bench.dut().out_value_o != expected(n + 1 - Latency);
        ++compared;
    }
    CHECK(compared == Inputs);
    CHECK(mismatches == 0);
}

TEST_CASE("the RTL lerp loses and repeats nothing under back pressure") {
    Bench bench;
    std::uint32_t next_in = 0, next_out = 0, mismatches = 0;
    std::uint32_t random = 12345;
    while (next_out < 100000) {
        random = random * 1664525u + 1013904223u;
        const std::uint32_t input = next_in * 2654435761u >> 8;
        bench.dut().in_valid_i = (random >> 16) & 1;
        bench.dut().in_a_i = static_cast<CData>(input);
        bench.dut().in_b_i = static_cast<CData>(input >> 8);
        bench.dut().in_weight_i = static_cast<CData>(input >> 16);
        bench.dut().out_ready_i = (random >> 17) & 1;
        bench.dut().eval(); // Ready and valid settle before the edge.
        if (bench.dut().out_valid_o && bench.dut().out_ready_i) {
            mismatches += bench.dut().out_value_o != expected(next_out * 2654435761u >> 8);
            ++next_out;
        }
        next_in += bench.dut().in_valid_i && bench.dut().in_ready_o;
        bench.step();
    }
    CHECK(mismatches == 0);
}

} // namespace
} // namespace ffgpu
