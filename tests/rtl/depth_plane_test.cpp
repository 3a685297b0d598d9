// rtl/depth_plane.sv against interpolate_depth_scalar().

#include "Vdepth_plane.h"
#include "model/raster/interpolator.h"
#include "rtl/bundles/plane.h"
#include "tests/rtl/bench/random_offset.h"
#include "tests/rtl/bench/unit_bench.h"

#include <memory>

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct DepthPlaneUnit {
    static constexpr const char* Name = "depth_plane";
    static constexpr std::string_view Latency = "DepthPlaneLatency";
    static constexpr std::uint64_t ShortItems = 1000000, LongItems = 10000000;

    using Dut = Vdepth_plane;
    using State = NoState;
    using Input = DepthPlaneQuad;
    using Output = LaneDepths;

    static void set_tag(DepthPlaneQuad& quad, unsigned tag) { quad.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    static std::int64_t random_step(Random& random) {
        const auto magnitude = static_cast<std::int64_t>(random.bits() >> (1 + random.below(63)));
        return random.one_in(2) ? -magnitude : magnitude;
    }
    // The sum near the range's ends, near a half, or anywhere.
    static DepthPlaneQuad random_input(Random& random, const State&) {
        DepthPlaneQuad quad{.place = static_cast<std::uint16_t>(random.below(1024)),
                            .x = random_offset(random),
                            .y = random_offset(random),
                            .dx = random_step(random),
                            .dy = random_step(random),
                            .depth_min = random.word() >> 8,
                            .depth_max = random.word() >> 8};
        if (random.one_in(8)) quad.depth_min = 0;
        if (random.one_in(8)) quad.depth_max = 0xffffff;
        if (quad.depth_min > quad.depth_max) std::swap(quad.depth_min, quad.depth_max);
        const std::uint32_t inside =
            quad.depth_min + random.below(quad.depth_max - quad.depth_min + 1);
        const std::array<std::uint32_t, 3> targets{quad.depth_min, inside, quad.depth_max};
        const std::uint64_t fraction =
            random.one_in(4) ? (1u << 23) + random.below(3) - 1 : random.below(1u << 24);
        std::uint64_t at = (std::uint64_t{targets[random.below(3)]} << 24) + fraction;
        if (random.one_in(4)) at -= std::uint64_t{1} << 24;
        if (random.one_in(8)) at = random.bits();
        quad.origin =
            static_cast<std::int64_t>(at - product(quad.dx, quad.x) - product(quad.dy, quad.y));
        return quad;
    }
    static std::uint64_t product(std::int64_t step, int count) {
        return static_cast<std::uint64_t>(step) * static_cast<std::uint64_t>(std::int64_t{count});
    }

    static void declare(Bins& bins) {
        bins.declare("clamped below, inside, clamped above", 3);
        bins.declare("fraction below, at, above the half", 3);
        bins.declare("sign of the sum", 2);
    }
    static void cover(Bins& bins, const State&, const DepthPlaneQuad& quad) {
        const auto sum =
            static_cast<std::int64_t>(static_cast<std::uint64_t>(quad.origin) +
                                      product(quad.dx, quad.x) + product(quad.dy, quad.y));
        const std::int64_t whole = sum >> 24, fraction = sum & 0xffffff;
        bins.hit("clamped below, inside, clamped above",
                 whole < quad.depth_min    ? 0
                 : whole <= quad.depth_max ? 1
                                           : 2);
        bins.hit("fraction below, at, above the half",
                 fraction < 0x800000    ? 0
                 : fraction == 0x800000 ? 1
                                        : 2);
        bins.hit("sign of the sum", sum < 0);
    }

    void expect(const State&, const DepthPlaneQuad& quad, std::vector<LaneDepths>& outputs) {
        record_->depth = {quad.origin, quad.dx, quad.dy};
        record_->depth_min = quad.depth_min;
        record_->depth_max = quad.depth_max;
        // A batch's places are unsigned: the reference pixel is where that suits them.
        record_->x_reference = 0x4000 - quad.x;
        record_->y_reference = 0x4000 - quad.y;
        batch_->quad_count = 1;
        batch_->x[0] = batch_->y[0] = 0x4000;
        const BatchRun run{record_.get(), 0};
        interpolate_depth_scalar({&run, 1}, *batch_);
        LaneDepths lanes{.tag = quad.tag, .place = quad.place};
        std::copy_n(batch_->depth.begin(), 4, lanes.depths.begin());
        outputs.push_back(lanes);
    }

private:
    std::unique_ptr<SetupRecord> record_ = std::make_unique<SetupRecord>();
    std::unique_ptr<FragmentBatch> batch_ = std::make_unique<FragmentBatch>();
};
using Unit = DepthPlaneUnit;

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
