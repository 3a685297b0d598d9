// rtl/perspective.sv against the scalar interpolator.

#include "Vperspective.h"
#include "model/arith/range.h"
#include "model/raster/interpolator.h"
#include "rtl/bundles/plane.h"
#include "tests/rtl/bench/unit_bench.h"

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

constexpr float power_of_two(std::uint8_t biased_exponent) {
    return std::bit_cast<float>(std::uint32_t{biased_exponent} << 23);
}

struct Perspective {
    static constexpr const char* Name = "perspective";
    static constexpr std::string_view Latency = "PerspectiveLatency";
    static constexpr std::uint64_t ShortItems = 500000, LongItems = 10000000;
    static constexpr unsigned KindCount = 8; // three of them beyond the list

    using Dut = Vperspective;
    using State = NoState;
    using Input = PerspectiveQuad;
    using Output = LaneValues;

    static void set_tag(PerspectiveQuad& quad, unsigned tag) { quad.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    static std::int32_t random_integer(Random& random) {
        if (random.one_in(30)) return random.one_in(2) ? INT32_MIN : INT32_MAX;
        const auto magnitude = static_cast<std::int32_t>(random.word() >> (1 + random.below(31)));
        return random.one_in(2) ? -magnitude : magnitude;
    }
    // What a colour's product is in units of 1/2: below 0, above 255, on halves.
    static void random_color(Random& random, PerspectiveQuad& quad) {
        const auto near = static_cast<std::int32_t>(random.below(560)) - 20;
        quad.values = {near, near + 1, near - 1, near};
        quad.factors.fill(1);
        quad.scale = 126;
        if (random.one_in(2)) return;
        // A hair beside them.
        for (std::int32_t& value : quad.values)
            value = value * (1 << 14) + static_cast<std::int32_t>(random.below(3)) - 1;
        quad.scale = 126 - 14;
    }
    static PerspectiveQuad random_input(Random& random, const State&) {
        PerspectiveQuad quad{.place = static_cast<std::uint16_t>(random.below(1024)),
                             .kind = random.any<PerspectiveKind>(KindCount),
                             .scale = static_cast<std::uint8_t>(69 + random.below(136))};
        for (std::int32_t& value : quad.values)
            value = random.one_in(30) ? 0 : random_integer(random);
        quad.floor = quad.values[random.below(4)] / 2 + static_cast<std::int32_t>(random.below(3));
        for (float& factor : quad.factors)
            factor = random.one_in(8) ? 1.0f
                                      : std::bit_cast<float>((random.word() & 0x807fffff) |
                                                             (96 + random.below(31)) << 23);
        if (quad.kind == PerspectiveKind::Color && !random.one_in(4)) random_color(random, quad);
        // 2^-32 to 2^32 of a number of 31 bits: on either side of what fog takes.
        if (quad.kind == PerspectiveKind::Fog)
            quad.scale = static_cast<std::uint8_t>(80 + random.below(70));
        return quad;
    }

    static void declare(Bins& bins) {
        bins.declare("kind", KindCount);
        bins.declare("conversion exact, down, up", 3);
        bins.declare("floor or 1 taken", 2);
        bins.declare("colour 0, between, 255", 3);
        bins.declare("fog 0, between, least, most", 4);
        bins.declare("sign", 2);
    }
    void cover(Bins& bins, const State&, const PerspectiveQuad& quad) {
        bins.hit("kind", static_cast<std::size_t>(quad.kind));
        for (unsigned lane = 0; lane < 4; ++lane) {
            const std::int32_t value = quad.values[lane];
            const double exact = value;
            const double converted = double{static_cast<float>(value)};
            const double size = std::abs(exact);
            bins.hit("sign", value < 0);
            bins.hit("conversion exact, down, up",
                     converted == exact           ? 0
                     : std::abs(converted) < size ? 1
                                                  : 2);
            if (quad.kind == PerspectiveKind::InverseW)
                bins.hit("floor or 1 taken", value < quad.floor);
            const std::uint32_t result = lane_value(quad, lane);
            if (quad.kind == PerspectiveKind::Color)
                bins.hit("colour 0, between, 255", result == 0 ? 0 : result == 255 ? 2 : 1);
            if (quad.kind != PerspectiveKind::Fog) continue;
            const float fog = std::abs(std::bit_cast<float>(result));
            bins.hit("fog 0, between, least, most",
                     fog == 0             ? 0
                     : fog == LargestFog  ? 3
                     : fog < 2 * LeastFog ? 2
                                          : 1);
        }
    }

    void expect(const State&, const PerspectiveQuad& quad, std::vector<LaneValues>& outputs) {
        LaneValues lanes{.tag = quad.tag, .place = quad.place};
        for (unsigned lane = 0; lane < 4; ++lane)
            lanes.values[lane] = lane_value(quad, lane);
        outputs.push_back(lanes);
    }

    // The model's interpolator on a plane that has the quad's integers.
    std::uint32_t lane_value(const PerspectiveQuad& quad, unsigned lane) {
        const float scale = power_of_two(quad.scale);
        switch (quad.kind) {
        case PerspectiveKind::InverseW:
            return product(std::max(quad.values[lane], quad.floor), quad.factors[lane], scale);
        case PerspectiveKind::Q:
            return product(
                quad.values[lane] == 0 ? 1 : quad.values[lane], quad.factors[lane], scale);
        default:
            return interpolated(quad, lane, scale);
        }
    }
    static std::uint32_t product(std::int32_t value, float factor, float scale) {
        return std::bit_cast<std::uint32_t>((static_cast<float>(value) * factor) * scale);
    }

private:
    // Planes stand behind their record.
    struct Primitive {
        SetupRecord record;
        std::array<StoredPlane, 4> planes;
    };

    // The lane as the corner of a quad: a plane without steps.
    std::uint32_t interpolated(const PerspectiveQuad& quad, unsigned lane, float scale) {
        const AttributePlane plane{
            .c = std::int64_t{quad.values[lane]} * (1 << 14), .dx = 0, .dy = 0, .scale = scale};
        primitive_->planes.fill(StoredPlane(plane));
        primitive_->record.plane_count = 4;
        batch_->quad_count = 1;
        batch_->x[0] = batch_->y[0] = 0;
        perspective_->w.fill(quad.factors[lane]);
        const BatchRun run{&primitive_->record, 0};
        InterpolantLayout layout;
        switch (quad.kind) {
        case PerspectiveKind::Color:
            layout.color = 0;
            interpolate_colors_scalar(layout, {&run, 1}, *perspective_, *batch_);
            return batch_->primary.r[0];
        case PerspectiveKind::Fog:
            layout.fog = 0;
            interpolate_colors_scalar(layout, {&run, 1}, *perspective_, *batch_);
            return std::bit_cast<std::uint32_t>(batch_->fog_coordinate[0]);
        default:
            layout.tex_coord[0] = 0;
            layout.tex_components[0] = 2;
            interpolate_tex_coords_scalar(
                layout, 0, {&run, 1}, *perspective_, *batch_, *coordinates_);
            return std::bit_cast<std::uint32_t>(coordinates_->s[0]);
        }
    }

    std::unique_ptr<Primitive> primitive_ = std::make_unique<Primitive>();
    std::unique_ptr<FragmentBatch> batch_ = std::make_unique<FragmentBatch>();
    std::unique_ptr<PerspectivePlanes> perspective_ = std::make_unique<PerspectivePlanes>();
    std::unique_ptr<TexCoordPlanes> coordinates_ = std::make_unique<TexCoordPlanes>();
};
using Unit = Perspective;

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
