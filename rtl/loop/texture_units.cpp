// Texture units: levels, texels' places, texels, filters. The image's memory is the host's.

#include "Vfilter_tree.h"
#include "Vlevel_of_detail.h"
#include "Vtexel_address.h"
#include "Vtexel_decode.h"
#include "model/texture/texel_read.h"
#include "rtl/bundles/texture_words.h"
#include "rtl/loop/loop_stages.h"
#include "rtl/loop/observed_texels.h"
#include "rtl/loop/quads.h"
#include "rtl/loop/unit_driver.h"

#include <algorithm>

namespace ffgpu::rtl {
namespace {

struct LevelOfDetailUnit : OneToOne<LevelQuad> {
    static constexpr const char* Name = "level_of_detail";
    using Dut = Vlevel_of_detail;
    using State = TextureWords;
    using Input = LevelQuad;
    using Output = QuadLevels;
};

// Requests as many as live lanes, probes and levels.
struct TexelAddressUnit {
    static constexpr const char* Name = "texel_address";
    using Dut = Vtexel_address;
    using State = TextureWords;
    using Input = AddressQuad;
    using Output = TexelRequest;

    static std::size_t outputs_of(std::span<const AddressQuad> quads) {
        std::size_t sum = 0;
        for (const AddressQuad& quad : quads)
            sum += static_cast<std::size_t>(std::popcount(quad.live)) * quad.levels.probes *
                   (quad.levels.weight == 0 ? 1 : 2);
        return sum;
    }
};

struct TexelDecodeUnit : OneToOne<TexelBlock> {
    static constexpr const char* Name = "texel_decode";
    using Dut = Vtexel_decode;
    using State = NoState;
    using Input = TexelBlock;
    using Output = Texel;
};

// A sample for each fragment.
struct FilterTreeUnit {
    static constexpr const char* Name = "filter_tree";
    using Dut = Vfilter_tree;
    using State = NoState;
    using Input = FilterLevel;
    using Output = Texel;

    static std::size_t outputs_of(std::span<const FilterLevel> levels) {
        const auto ends = [](const FilterLevel& level) {
            return level.last_level && level.last_probe;
        };
        return static_cast<std::size_t>(std::ranges::count_if(levels, ends));
    }
};

constexpr const char* AllFour = "level_of_detail, texel_address, texel_decode, filter_tree";

// One batch on its way through the four.
class Sampling {
public:
    Sampling(const TextureUnit& unit,
             const TexCoordPlanes& coordinates,
             const SampleQuads& quads,
             const ObservedTexels& seen)
        : unit_(unit)
        , words_(texture_words(unit))
        , coordinates_(coordinates)
        , quads_(quads)
        , seen_(seen) {}

    void run(ColorPlanes& out) {
        choose_levels();
        find_texels();
        decode();
        filter(out);
    }

private:
    void choose_levels() {
        std::vector<LevelQuad> inputs;
        for (const unsigned q : seen_.quads)
            inputs.push_back(level_quad(q));
        const auto levels = unit<LevelOfDetailUnit>().run(words_, inputs, bank_);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const QuadSampling& expected = seen_.samplings[i];
            const StageDifference at = at_place(LevelOfDetailUnit::Name, 4 * seen_.quads[i]);
            compare_lane(at, "level", expected.level, levels[i].level);
            compare_lane(at, "next_level", expected.next_level, levels[i].next_level);
            compare_lane(at, "weight", expected.weight, levels[i].weight);
            compare_lane(at, "linear", expected.linear, levels[i].linear);
            compare_lane(at, "probes", expected.probes, levels[i].probes);
            // Only between several probes does it count.
            const TexCoord& step = expected.major_step;
            const std::array model{step.s, step.t, step.r};
            for (unsigned axis = 0; axis < unit_.dimensions && expected.probes > 1; ++axis)
                compare_lane(at,
                             "major_step",
                             std::bit_cast<std::uint32_t>(model[axis]),
                             std::bit_cast<std::uint32_t>(levels[i].major_step[axis]));
            addresses_.push_back(address_quad(seen_.quads[i], levels[i]));
        }
    }
    // The faces of cube maps are the model's.
    LevelQuad level_quad(unsigned q) const {
        LevelQuad quad;
        const unsigned covered = quads_.covered.quad(q);
        const unsigned quad_face =
            cube_face(coordinates_of(coordinates_, 4 * q + face_lane(covered)));
        for (unsigned lane = 0; lane < 4; ++lane) {
            TexCoord at = coordinates_of(coordinates_, 4 * q + lane);
            if (unit_.kind == TextureKind::Cube) {
                quad.one_face &= cube_face(at) == quad_face;
                at = project_to_face(quad_face, at);
            }
            put_coordinates(quad.coordinates, lane, at);
        }
        return quad;
    }
    AddressQuad address_quad(unsigned q, const QuadLevels& levels) const {
        AddressQuad quad{.live = static_cast<std::uint8_t>(quads_.live.quad(q)), .levels = levels};
        quad.levels.place = static_cast<std::uint16_t>(q);
        for (unsigned lane = 0; lane < 4; ++lane) {
            TexCoord at = coordinates_of(coordinates_, 4 * q + lane);
            if (unit_.kind == TextureKind::Cube) {
                quad.faces[lane] = static_cast<std::uint8_t>(cube_face(at));
                at = project_to_face(quad.faces[lane], at);
            }
            put_coordinates(quad.coordinates, lane, at);
        }
        return quad;
    }
    static void put_coordinates(std::array<float, 12>& to, unsigned lane, const TexCoord& at) {
        to[3 * lane] = at.s;
        to[3 * lane + 1] = at.t;
        to[3 * lane + 2] = at.r;
    }

    void find_texels() {
        const auto requests = unit<TexelAddressUnit>().run(words_, addresses_, bank_);
        for (const TexelRequest& request : requests) {
            lanes_.push_back(lane_of(request));
            levels_.push_back({.last_level = request.last_level,
                               .last_probe = request.last_probe,
                               .probes = request.probes,
                               .level_weight = request.level_weight,
                               .weight_z = request.weight_z,
                               .weight_y = request.weight_y,
                               .weight_x = request.weight_x});
            counts_.push_back(request.linear ? 1u << unit_.dimensions : 1u);
            for (unsigned i = 0; i < counts_.back(); ++i)
                blocks_.push_back(read(request, i));
        }
        compare_requests();
    }
    // Their texels, then their weights.
    void compare_requests() const {
        const char* const unit = TexelAddressUnit::Name;
        for (std::size_t i = 0; i < std::min(seen_.blocks.size(), blocks_.size()); ++i)
            compare_bundles(at_place(unit, seen_.lanes[i]), seen_.blocks[i], blocks_[i]);
        std::size_t first = 0; // block of a request
        for (std::size_t i = 0; i < std::min(seen_.levels.size(), levels_.size()); ++i) {
            if (first < seen_.lanes.size())
                compare_bundles(at_place(unit, seen_.lanes[first]), seen_.levels[i], levels_[i]);
            first += counts_[i];
        }
        compare_lane(at_place(unit, 0),
                     "number of requests",
                     static_cast<std::uint32_t>(seen_.levels.size()),
                     static_cast<std::uint32_t>(levels_.size()));
    }
    // Texel 4 z + 2 y + x of a request, and its block.
    TexelBlock read(const TexelRequest& request, unsigned number) const {
        const auto place = [&](unsigned axis) -> unsigned {
            const std::uint16_t at = request.places[2 * axis + (number >> axis & 1)];
            return at == TexelRequest::Border ? TexelAccess::BorderTexel : at;
        };
        const unsigned x = place(0), y = place(1), layer = place(2);
        const float r = coordinates_.r[lane_of(request)];
        TexelBlock block = texel_block(unit_, r, x, y, layer);
        const FormatInfo& info = format_info(unit_.format);
        const LevelTable& levels = unit_.levels;
        if (!block.is_border && is_stored(request.level, {x, y, layer}))
            std::memcpy(block.block.data(),
                        unit_.texels + levels.offset[request.level] +
                            std::size_t{layer} * levels.layer_stride[request.level] +
                            std::size_t{y / info.block_height} * levels.row_stride[request.level] +
                            std::size_t{x / info.block_width} * info.block_bytes,
                        info.block_bytes);
        return block;
    }
    // Of a faulty unit anything may be asked.
    bool is_stored(unsigned level, const std::array<unsigned, 3>& texel) const {
        for (unsigned axis = 0; axis < unit_.dimensions; ++axis) {
            const std::int32_t size = level_extent(unit_, axis, level) + 2 * unit_.border;
            if (texel[axis] >= static_cast<unsigned>(size)) return false;
        }
        const unsigned faces = unit_.kind == TextureKind::Cube ? 6 : 1;
        return level <= unit_.last_level && (unit_.dimensions == 3 || texel[2] < faces);
    }
    unsigned lane_of(const TexelRequest& request) const {
        return (4u * request.place + request.lane) % BatchFragments;
    }
    StageDifference at_place(const char* unit, unsigned lane) const {
        if (batch_) return at_lane(unit, *batch_, lane);
        return {.unit = unit, .field = {}, .lane = lane % 4};
    }

    // Texels in their places: an axis that is not filtered has a weight of 0.
    void decode() {
        const auto decoded = unit<TexelDecodeUnit>().run({}, blocks_);
        std::size_t next = 0;
        for (std::size_t i = 0; i < levels_.size(); ++i)
            for (unsigned at = 0; at < counts_[i]; ++at, ++next) {
                if (next < seen_.colors.size())
                    compare_lane(at_place(TexelDecodeUnit::Name, seen_.lanes[next]),
                                 "color",
                                 pack_rgba8(seen_.colors[next]),
                                 decoded[next].color);
                levels_[i].texels[at] = decoded[next].color;
            }
    }

    // `out` has the model's samples, and gets the unit's.
    void filter(ColorPlanes& out) {
        const auto samples = unit<FilterTreeUnit>().run({}, levels_);
        std::size_t next = 0;
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            if (!levels_[i].last_level || !levels_[i].last_probe) continue;
            const std::uint32_t got = samples[next++].color;
            const unsigned lane = lanes_[i];
            compare_lane(
                at_place(FilterTreeUnit::Name, lane), "color", packed_color(out, lane), got);
            set_lane_color(out, lane, unpack_rgba8(got));
        }
    }

    const TextureUnit& unit_;
    const TextureWords words_;
    const TexCoordPlanes& coordinates_;
    const SampleQuads& quads_;
    const ObservedTexels& seen_;
    // Whose coordinates they are; null: an image's.
    const FragmentBatch* const batch_ = std::exchange(loop_log().batch, nullptr);
    const unsigned bank_ = batch_ ? bank_of(*batch_) : 0;
    std::vector<AddressQuad> addresses_;
    std::vector<TexelBlock> blocks_;
    std::vector<FilterLevel> levels_;
    std::vector<unsigned> counts_, lanes_; // of each level: texels, lane of the batch
};

const char* reason_against(const TextureUnit& unit) {
    if (!unit.valid) return "textures without an image";
    if (unit.filter != TextureFilter::Standard) return "wide filters";
    return nullptr;
}

} // namespace

void make_tex_coords(const InterpolantLayout& layout,
                     unsigned unit_number,
                     BatchRuns runs,
                     const PerspectivePlanes& perspective,
                     const FragmentBatch& batch,
                     TexCoordPlanes& out) {
    FastStages.interpolate_tex_coords(layout, unit_number, runs, perspective, batch, out);
    loop_log().batch = &batch;
}

void make_directions(const InterpolantLayout& layout,
                     unsigned unit_number,
                     BatchRuns runs,
                     const PerspectivePlanes& perspective,
                     const FragmentBatch& batch,
                     TexCoordPlanes& out) {
    FastStages.interpolate_directions(layout, unit_number, runs, perspective, batch, out);
    loop_log().batch = &batch;
}

void sample(const TextureUnit& texture,
            TexCoordPlanes& coordinates,
            const SampleQuads& quads,
            ColorPlanes& out,
            TexelFootprints* footprints) {
    if (const char* const reason = reason_against(texture)) {
        FastStages.sample(texture, coordinates, quads, out, footprints);
        return loop_log().count(AllFour, reason, quads.live.count());
    }
    ObservedTexels seen(texture, coordinates);
    sample_scalar(texture, coordinates, quads, out, footprints, &seen);
    Sampling(texture, coordinates, quads, seen).run(out);
    const char* const feature = texture.kind == TextureKind::Cube ? "cube maps, their faces alone"
                                : texture.compares() ? "depth comparisons, their references alone"
                                                     : "";
    loop_log().count(AllFour, feature, quads.live.count());
}

} // namespace ffgpu::rtl
