// What an observer of quads is told adds up to the machine's counters, and costs no cycle.

#include "model/timing/quad_observer.h"
#include "tests/timing/textured_draws.h"

#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Observed final : QuadObserver {
    std::uint64_t lines = 0, misses = 0, retired_quads = 0, last = 0;
    std::uint64_t depth_lines = 0, depth_misses = 0, color_lines = 0, color_misses = 0;
    std::set<QuadName> names;
    bool in_order = true;

    void texel_line(const QuadName& quad, const CacheLine& line) override {
        ++lines;
        misses += line.missed;
        names.insert(quad);
    }
    void depth_line(const QuadName&, const CacheLine& line) override {
        ++depth_lines;
        depth_misses += line.missed;
    }
    void color_line(const QuadName&, const CacheLine& line) override {
        ++color_lines;
        color_misses += line.missed;
    }
    void retired(const QuadName& quad, std::uint64_t cycle) override {
        ++retired_quads;
        in_order = in_order && cycle >= last && names.contains(quad);
        last = cycle;
    }
};

TEST_CASE("an observer is told of each look-up in the texel cache and of each quad's end") {
    for (const std::uint32_t pipes : {1u, 4u}) {
        TimingConfig config = wide_machine(pipes);
        config.texel_cache.sets = 2; // so small that lines come again
        WorkBin bin = textured_draw(2);
        auto state = std::make_shared<Registers>(*bin.draws[0].state);
        state->blend.write_mask = 0xf;
        bin.draws[0].state = state;
        const Figures figures = run(config, bin);
        Observed observed;
        GpuTiming timing(config);
        timing.set_quad_observer(&observed);
        work::CommandAssembler assembler(timing);
        assembler.bin(std::make_shared<const WorkBin>(bin));
        assembler.end_frame(0);
        CHECK(figures_of(timing) == figures);
        CHECK(observed.lines == figures.at("texel_cache_accesses"));
        CHECK(observed.misses == figures.at("texel_cache_misses"));
        CHECK((observed.misses > 0 && observed.misses < observed.lines));
        CHECK(observed.depth_lines == figures.at("depth_cache_accesses"));
        CHECK(observed.depth_misses == figures.at("depth_cache_misses"));
        CHECK(observed.color_lines == figures.at("color_cache_accesses"));
        CHECK(observed.color_misses == figures.at("color_cache_misses"));
        CHECK(observed.color_lines > 0);
        CHECK(observed.retired_quads == FillQuads);
        CHECK(observed.names.size() == FillQuads);
        CHECK(observed.in_order);
        CHECK(observed.last <= figures.at("total_cycles"));
    }
}

} // namespace
} // namespace ffgpu::timing
