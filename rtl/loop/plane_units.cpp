// Attributes: planes' integers, reciprocals of 1/w and q, and what the integers mean.

#include "Vattribute_plane.h"
#include "Vperspective.h"
#include "Vreciprocal.h"
#include "model/arith/reciprocal.h"
#include "rtl/bundles/plane.h"
#include "rtl/bundles/tagged_float.h"
#include "rtl/loop/loop_stages.h"
#include "rtl/loop/unit_driver.h"

#include <algorithm>
#include <bit>

namespace ffgpu::rtl {
namespace {

struct AttributePlaneUnit : OneToOne<PlaneQuad> {
    static constexpr const char* Name = "attribute_plane";
    using Dut = Vattribute_plane;
    using State = NoState;
    using Input = PlaneQuad;
    using Output = LaneValues;
};

struct ReciprocalUnit : OneToOne<TaggedFloat> {
    static constexpr const char* Name = "reciprocal";
    using Dut = Vreciprocal;
    using State = NoState;
    using Input = TaggedFloat;
    using Output = TaggedFloat;
};

struct PerspectiveUnit : OneToOne<PerspectiveQuad> {
    static constexpr const char* Name = "perspective";
    using Dut = Vperspective;
    using State = NoState;
    using Input = PerspectiveQuad;
    using Output = LaneValues;
};

constexpr const char* AllThree = "attribute_plane, reciprocal, perspective";

std::uint8_t biased_exponent(float power_of_two) {
    return static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(power_of_two) >> 23);
}

using LaneFloats = std::array<float, 4>;

// One attribute of some quads of a batch on its way through the units.
class Attribute {
public:
    Attribute(BatchRuns runs, const FragmentBatch& batch)
        : runs_(runs)
        , batch_(batch) {}

    // `visit(record, q)`: the quads in their order.
    template <class Visit>
    void for_each_quad(const Visit& visit) const {
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            const unsigned end = i + 1 < runs_.size() ? runs_[i + 1].first_quad : batch_.quad_count;
            for (unsigned q = runs_[i].first_quad; q < end; ++q)
                visit(*runs_[i].record, q);
        }
    }

    // A quad to be computed: its plane, and what becomes of the plane's integers.
    void add(const SetupRecord& record,
             unsigned q,
             const AttributePlane& plane,
             const PerspectiveQuad& then) {
        const std::int64_t c = plane.c + AttributePlane::Half;
        constexpr std::int64_t Mask = (1 << AttributePlane::GuardBits) - 1;
        planes_.push_back(plane);
        inputs_.push_back({.x = static_cast<std::int16_t>(batch_.x[q] - record.x_reference),
                           .y = static_cast<std::int16_t>(batch_.y[q] - record.y_reference),
                           .whole = static_cast<std::int32_t>(c >> AttributePlane::GuardBits),
                           .fraction = static_cast<std::uint32_t>(c & Mask),
                           .dx = plane.dx,
                           .dy = plane.dy});
        then_.push_back(then);
        quads_.push_back(q);
    }

    // `take(lane of the batch, bits)`
    template <class Take>
    void run(const Take& take) {
        const auto integers = unit<AttributePlaneUnit>().run({}, inputs_);
        for (std::size_t i = 0; i < then_.size(); ++i)
            for (unsigned lane = 0; lane < 4; ++lane) {
                const PlaneQuad& quad = inputs_[i];
                const std::int32_t expected =
                    planes_[i].corner(quad.x, quad.y) + planes_[i].lane_offsets()[lane];
                const std::uint32_t got = integers[i].values[lane];
                compare(AttributePlaneUnit::Name,
                        4 * quads_[i] + lane,
                        "values",
                        static_cast<std::uint32_t>(expected),
                        got);
                then_[i].values[lane] = static_cast<std::int32_t>(got);
            }
        const auto results = unit<PerspectiveUnit>().run({}, then_);
        for (std::size_t i = 0; i < results.size(); ++i)
            for (unsigned lane = 0; lane < 4; ++lane)
                take(4 * quads_[i] + lane, results[i].values[lane]);
    }

    // The same, and the numbers' reciprocals.
    template <class Take>
    void run_reciprocals(const Take& take) {
        std::vector<TaggedFloat> divisors;
        std::vector<unsigned> lanes;
        run([&](unsigned lane, std::uint32_t bits) {
            divisors.push_back({.value = std::bit_cast<float>(bits)});
            lanes.push_back(lane);
        });
        const auto reciprocals = unit<ReciprocalUnit>().run({}, divisors);
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            compare(PerspectiveUnit::Name,
                    lanes[i],
                    "divisor",
                    divisor_bits(i),
                    bits_of(divisors[i].value));
            compare(ReciprocalUnit::Name,
                    lanes[i],
                    "value",
                    bits_of(reciprocal(divisors[i].value)),
                    bits_of(reciprocals[i].value));
            take(lanes[i], reciprocals[i].value);
        }
    }

    void clear() {
        planes_.clear();
        inputs_.clear();
        then_.clear();
        quads_.clear();
    }
    // Of the live lanes; what is wrong of the others shows where it is wanted.
    void compare(const char* unit_name,
                 unsigned lane,
                 const char* field,
                 std::uint32_t expected,
                 std::uint32_t got) const {
        if (batch_.live.test(lane))
            compare_lane(at_lane(unit_name, batch_, lane), field, expected, got);
    }
    // A value from the units in the place of the model's.
    void take_float(unsigned lane, const char* field, float& value, float got) const {
        compare(PerspectiveUnit::Name, lane, field, bits_of(value), bits_of(got));
        value = got;
    }

private:
    static std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }
    // What the model divides by, of the i-th lane.
    std::uint32_t divisor_bits(std::size_t i) const {
        const PerspectiveQuad& quad = then_[i / 4];
        const std::int32_t value = quad.values[i % 4];
        const std::int32_t least = quad.kind == PerspectiveKind::Q ? (value == 0 ? 1 : value)
                                                                   : std::max(value, quad.floor);
        return bits_of(static_cast<float>(least));
    }

    BatchRuns runs_;
    const FragmentBatch& batch_;
    std::vector<AttributePlane> planes_;
    std::vector<PlaneQuad> inputs_;
    std::vector<PerspectiveQuad> then_;
    std::vector<unsigned> quads_;
};

LaneFloats quad_floats(std::span<const float> lanes, unsigned q) {
    return {lanes[4 * q], lanes[4 * q + 1], lanes[4 * q + 2], lanes[4 * q + 3]};
}

struct ColorPlane {
    const char* field;
    int first; // of its planes
    unsigned channels;
    bool SetupRecord::*constant;
};

void interpolate_color(const ColorPlane& color,
                       Attribute attribute,
                       const PerspectivePlanes& perspective,
                       ColorPlanes& to) {
    const std::array<std::uint16_t*, 4> planes{to.r.data(), to.g.data(), to.b.data(), to.a.data()};
    for (unsigned i = 0; i < color.channels; ++i) {
        attribute.clear();
        attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
            if (record.*color.constant) return;
            const AttributePlane plane = record.plane(static_cast<unsigned>(color.first) + i);
            attribute.add(record,
                          q,
                          plane,
                          {.kind = PerspectiveKind::Color,
                           .scale = biased_exponent(plane.scale),
                           .factors = quad_floats(perspective.w, q)});
        });
        attribute.run([&](unsigned lane, std::uint32_t got) {
            attribute.compare(PerspectiveUnit::Name, lane, color.field, planes[i][lane], got);
            planes[i][lane] = static_cast<std::uint16_t>(got);
        });
    }
}

// How a coordinate follows from its plane.
PerspectiveQuad
times_w(const AttributePlane& plane, const PerspectivePlanes& perspective, unsigned q) {
    return {.scale = biased_exponent(plane.scale), .factors = quad_floats(perspective.w, q)};
}

// 1/q where the primitive divides by it.
void divide_one_by_q(const TexCoordSource& source, Attribute attribute, std::span<float> over_q) {
    attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
        if (source.divides(record))
            attribute.add(record, q, record.plane(source.first + 3), {.kind = PerspectiveKind::Q});
    });
    attribute.run_reciprocals([&](unsigned lane, float value) { over_q[lane] = value; });
}

} // namespace

void interpolate_perspective(BatchRuns runs,
                             const FragmentBatch& batch,
                             PerspectivePlanes& perspective) {
    FastStages.interpolate_perspective(runs, batch, perspective);
    Attribute attribute(runs, batch);
    attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
        if (record.perspective)
            attribute.add(record,
                          q,
                          record.inverse_w(),
                          {.kind = PerspectiveKind::InverseW, .floor = record.inverse_w_floor});
    });
    attribute.run_reciprocals([&](unsigned lane, float w) { perspective.w[lane] = w; });
}

void interpolate_colors(const InterpolantLayout& layout,
                        BatchRuns runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch) {
    FastStages.interpolate_colors(layout, runs, perspective, batch);
    Attribute attribute(runs, batch);
    if (layout.color >= 0)
        interpolate_color({"primary", layout.color, 4, &SetupRecord::constant_color},
                          attribute,
                          perspective,
                          batch.primary);
    if (layout.secondary >= 0)
        interpolate_color({"secondary", layout.secondary, 3, &SetupRecord::constant_secondary},
                          attribute,
                          perspective,
                          batch.secondary);
    batch.full_channels = 0; // What the units gave goes on, whatever it is.
    loop_log().count(AllThree, "", batch.live.count());
    if (layout.fog < 0) return;
    attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
        const AttributePlane plane = record.plane(static_cast<unsigned>(layout.fog));
        PerspectiveQuad then = times_w(plane, perspective, q);
        then.kind = PerspectiveKind::Fog;
        attribute.add(record, q, plane, then);
    });
    attribute.run([&](unsigned lane, std::uint32_t got) {
        attribute.take_float(
            lane, "fog_coordinate", batch.fog_coordinate[lane], std::bit_cast<float>(got));
    });
}

void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit_number,
                            BatchRuns runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    make_tex_coords(layout, unit_number, runs, perspective, batch, out);
    const std::array<float*, 3> planes{out.s.data(), out.t.data(), out.r.data()};
    const TexCoordSource source(layout, unit_number);
    std::array<float, BatchFragments> over_q{};
    divide_one_by_q(source, Attribute(runs, batch), over_q);
    for (unsigned i = 0; i < source.coordinates(); ++i) {
        Attribute attribute(runs, batch);
        attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
            const AttributePlane plane = record.plane(source.first + i);
            PerspectiveQuad then = times_w(plane, perspective, q);
            if (source.divides(record)) {
                const float q_scale = record.plane(source.first + 3).scale;
                then.scale = biased_exponent(divided_scale(plane.scale, q_scale));
                then.factors = quad_floats(over_q, q);
            }
            attribute.add(record, q, plane, then);
        });
        attribute.run([&](unsigned lane, std::uint32_t got) {
            attribute.take_float(lane, "coordinate", planes[i][lane], std::bit_cast<float>(got));
        });
    }
}

void interpolate_directions(const InterpolantLayout& layout,
                            unsigned unit_number,
                            BatchRuns runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    make_directions(layout, unit_number, runs, perspective, batch, out);
    const std::array<float*, 3> planes{out.s.data(), out.t.data(), out.r.data()};
    const TexCoordSource source(layout, unit_number);
    for (unsigned i = 0; i < source.coordinates(); ++i) {
        Attribute attribute(runs, batch);
        attribute.for_each_quad([&](const SetupRecord& record, unsigned q) {
            attribute.add(record,
                          q,
                          record.plane(source.first + i),
                          {.scale = biased_exponent(direction_scales(record, source)[i])});
        });
        attribute.run([&](unsigned lane, std::uint32_t got) {
            attribute.take_float(lane, "direction", planes[i][lane], std::bit_cast<float>(got));
        });
    }
}

} // namespace ffgpu::rtl
