// rtl/texel_address.sv against what sample_scalar() tells of its accesses.

#include "Vtexel_address.h"
#include "model/texture/coordinates.h"
#include "model/texture/level_of_detail.h"
#include "rtl/bundles/levels.h"
#include "tests/rtl/bench/random_texture.h"
#include "tests/rtl/bench/unit_bench.h"

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

// The model's accesses of one quad as the unit's requests.
class AccessObserver final : public TexelObserver {
public:
    AccessObserver(const AddressQuad& quad, std::vector<TexelRequest>& to)
        : quad_(quad)
        , requests_(to) {}

    void probe(unsigned lane, unsigned, const TexCoord&, const ProbeWeights&) override {
        probe_ = lane == lane_ ? probe_ + 1u : 1u;
        lane_ = lane;
        fine_ = true;
    }
    void level(const TexelAccess& access, const std::array<AxisTexels, 3>& axes) override {
        const QuadLevels& levels = quad_.levels;
        const auto weight = [&](unsigned axis) {
            const bool filters = (access.linear >> axis & 1) != 0;
            return static_cast<std::uint8_t>(filters ? axes[axis].weight : 0);
        };
        const auto place = [](std::uint16_t at) {
            return at == TexelAccess::BorderTexel ? TexelRequest::Border : at;
        };
        requests_.push_back({.tag = levels.tag,
                             .place = levels.place,
                             .lane = static_cast<std::uint8_t>(lane_),
                             .face = quad_.faces[lane_],
                             .level = access.level,
                             .linear = levels.linear,
                             .last_level = !fine_ || levels.weight == 0,
                             .last_probe = probe_ == levels.probes,
                             .probes = levels.probes,
                             .probe = static_cast<std::uint8_t>(probe_),
                             .level_weight = levels.weight,
                             .weight_z = weight(2),
                             .weight_y = weight(1),
                             .weight_x = weight(0),
                             .places = {place(access.x0),
                                        place(access.x1),
                                        place(access.y0),
                                        place(access.y1),
                                        place(access.layer0),
                                        place(access.layer1)}});
        if (quad_.faces[lane_] != 0)
            requests_.back().places[4] = requests_.back().places[5] = quad_.faces[lane_];
        fine_ = false;
    }
    void read(unsigned, unsigned, unsigned, unsigned) override {}

private:
    const AddressQuad& quad_;
    std::vector<TexelRequest>& requests_;
    unsigned lane_ = ~0u, probe_ = 0;
    bool fine_ = true;
};

struct TexelAddress {
    static constexpr const char* Name = "texel_address";
    static constexpr bool TakesEachCycle = false;
    static constexpr std::string_view Latency = "TexelAddressLatency";
    static constexpr std::uint64_t ShortItems = 40000, LongItems = 1000000; // some 10 requests each

    using Dut = Vtexel_address;
    using State = TextureWords;
    using Input = AddressQuad;
    using Output = TexelRequest;

    static void set_tag(AddressQuad& quad, unsigned tag) { quad.levels.tag = tag != 0; }
    static State random_state(Random& random) {
        State state = random_texture(random);
        if (!random.one_in(4)) state.sampler.max_anisotropy = 1;
        return state;
    }

    // Inside the image, at its edges, some images away, or anywhere.
    static float coordinate(Random& random, const State& state, unsigned axis) {
        const TextureShape& shape = state.image.shape;
        const std::uint32_t size = axis == 0 ? shape.width : axis == 1 ? shape.height : shape.depth;
        const bool counts = shape.kind == TextureKind::Rectangle;
        const float extent = counts ? static_cast<float>(size) : 1.0f;
        const float texel = static_cast<float>(random.below(2 * 256 * size) + 1) /
                            (512.0f * static_cast<float>(size)) * extent;
        switch (random.below(8)) {
        case 0: // halves of texels, where the nearest one changes and weights are 0
            return std::round(texel / extent * 2 * static_cast<float>(size)) /
                   (2 * static_cast<float>(size)) * extent;
        case 1:
            return random.one_in(2) ? extent : random_number(random, -80, 80);
        case 2:
            return random_number(random, -24, 3) * extent;
        case 3:
            return texel + extent * (static_cast<float>(random.below(9)) - 4);
        case 4:
            return -texel;
        default:
            return texel;
        }
    }
    static AddressQuad random_input(Random& random, const State& state) {
        AddressQuad quad{.live = static_cast<std::uint8_t>(random.below(16))};
        if (random.one_in(2)) quad.live = 15;
        const auto size = static_cast<float>(state.image.shape.width);
        const int lod = static_cast<int>(random.below(14)) - 2;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const float corner = coordinate(random, state, axis);
            for (unsigned lane = 0; lane < 4; ++lane)
                quad.coordinates[3 * lane + axis] =
                    lane == 0 || random.one_in(4)
                        ? corner
                        : corner + random_number(random, lod - 2, lod) / size;
        }
        choose_levels(random, state, quad);
        return quad;
    }
    // As the unit before it says. A cube map's coordinates are on faces already: to the model it is
    // an image of two dimensions, whose face is told beside.
    static TextureUnit flat_unit(const State& state) {
        TextureUnit unit = model_unit(state);
        if (unit.kind == TextureKind::Cube) unit.kind = TextureKind::TwoD;
        unit.levels = {}; // All texels are read from one place: there is no image.
        return unit;
    }
    static void choose_levels(Random& random, const State& state, AddressQuad& quad) {
        std::array<TexCoord, 4> lanes;
        for (unsigned lane = 0; lane < 4; ++lane)
            lanes[lane] = {quad.coordinates[3 * lane],
                           quad.coordinates[3 * lane + 1],
                           quad.coordinates[3 * lane + 2]};
        const QuadSampling sampling = sample_quad(flat_unit(state), lanes, true);
        const TexCoord& step = sampling.major_step;
        quad.levels = {.place = static_cast<std::uint16_t>(random.below(1024)),
                       .level = sampling.level,
                       .next_level = sampling.next_level,
                       .weight = sampling.weight,
                       .linear = sampling.linear,
                       .probes = sampling.probes,
                       .major_step = {step.s, step.t, step.r}};
        if (state.image.shape.kind == TextureKind::Cube)
            for (std::uint8_t& face : quad.faces)
                face = static_cast<std::uint8_t>(random.below(6));
    }

    void declare(Bins& bins) const {
        bins.declare("kind", 5);
        bins.declare("wrap mode, nearest and linear", 8 * 2);
        bins.declare("probes", MaxProbes);
        bins.declare("levels", 2);
        bins.declare("level", MaxTextureLevels);
        bins.declare("live lanes", 16);
        bins.declare("first texel inside, border; second", 4);
        bins.declare("stored border", 2);
        bins.declare("second texel beside, on the other side, the same", 3);
        bins.declare("weight 0", 2);
    }
    void cover(Bins& bins, const State& state, const AddressQuad& quad) {
        bins.hit("live lanes", quad.live);
        std::vector<TexelRequest> requests;
        expect(state, quad, requests);
        for (const TexelRequest& request : requests) {
            const auto number = [](auto value) { return static_cast<std::size_t>(value); };
            bins.hit("kind", number(state.image.shape.kind) - 1);
            bins.hit("wrap mode, nearest and linear",
                     2 * number(state.sampler.wrap[0]) + request.linear);
            bins.hit("probes", request.probes - 1u);
            bins.hit("levels", request.level_weight != 0);
            bins.hit("level", request.level);
            bins.hit("stored border", state.image.shape.border);
            const std::uint16_t first = request.places[0], second = request.places[1];
            bins.hit("first texel inside, border; second",
                     2u * (first == TexelRequest::Border) + (second == TexelRequest::Border));
            if (!request.linear) continue;
            bins.hit("weight 0", request.weight_x == 0);
            bins.hit("second texel beside, on the other side, the same",
                     second == first + 1 ? 0
                     : second < first    ? 1
                                         : 2);
        }
    }

    void expect(const State& state, const AddressQuad& quad, std::vector<Output>& outputs) {
        for (unsigned lane = 0; lane < 4; ++lane) {
            coordinates_->s[lane] = quad.coordinates[3 * lane];
            coordinates_->t[lane] = quad.coordinates[3 * lane + 1];
            coordinates_->r[lane] = quad.coordinates[3 * lane + 2];
        }
        SampleQuads quads;
        quads.count = 1;
        quads.covered.words[0] = 15;
        quads.live.words[0] = quad.live;
        AccessObserver observer(quad, outputs);
        sample_scalar(flat_unit(state), *coordinates_, quads, *colors_, nullptr, &observer);
    }

private:
    std::unique_ptr<TexCoordPlanes> coordinates_ = std::make_unique<TexCoordPlanes>();
    std::unique_ptr<ColorPlanes> colors_ = std::make_unique<ColorPlanes>();
};
using Unit = TexelAddress;

// A step of a power of two brings the lowest bits of a probe's position behind the point, where
// repeating leaves nothing else: all that is left is the weight and the texel beside it.
TEST_CASE("probes stand where the model has them, to the last bit of each position") {
    TexelAddress unit;
    UnitBench<TexelAddress> bench(unit);
    constexpr int LeastStep = 12, Steps = 13; // 2^12 to 2^24
    TextureWords words;
    words.image.shape = {.kind = TextureKind::TwoD,
                         .format = Format::Luminance8,
                         .width = 8,
                         .height = 8,
                         .depth = 1,
                         .levels = 1};
    words.sampler = {.wrap = {Wrap::Repeat, Wrap::Repeat, Wrap::Repeat},
                     .minify_linear = true,
                     .mip_filter = MipFilter::None,
                     .max_anisotropy = MaxProbes};
    Random random(9);
    const auto state = [&](unsigned) { return words; };
    // Lane 0 alone, whose pixel is `probes` times as wide as high, or almost so.
    const auto input = [&](unsigned n, unsigned i) {
        const unsigned probes = 2 + n;
        const float step = std::ldexp(1.0f, LeastStep + static_cast<int>(i));
        AddressQuad quad{.live = 1};
        quad.coordinates[3] = step;
        quad.coordinates[7] = step / (static_cast<float>(probes) - 0.5f);
        quad.coordinates[9] = quad.coordinates[3];
        quad.coordinates[10] = quad.coordinates[7];
        TexelAddress::choose_levels(random, words, quad);
        REQUIRE(quad.levels.probes == probes);
        REQUIRE(quad.levels.major_step[0] == step);
        return quad;
    };
    bench.run(counted_source<TexelAddress>(MaxProbes - 1, Steps, state, input), Stall::Never, 1);
    INFO(bench.report);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared == Steps * (MaxProbes * (MaxProbes + 1) / 2 - 1));
}

TEST_CASE("a request leaves each cycle, and one cycle lies between quads") {
    TexelAddress unit;
    UnitBench<TexelAddress> bench(unit);
    Random random(21);
    const TextureWords words = TexelAddress::random_state(random);
    const auto state = [&](unsigned) { return words; };
    const auto input = [&](unsigned, unsigned) { return unit.random_input(random, words); };
    constexpr unsigned Quads = 200;
    bench.run(counted_source<TexelAddress>(1, Quads, state, input), Stall::Never, 1);
    CHECK(bench.mismatches == 0);
    CHECK(bench.compared > 2 * Quads);
    CHECK(bench.cycles() == Quads + bench.compared + pipe_number(TexelAddress::Latency));
}

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"
