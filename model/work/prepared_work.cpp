#include "model/work/prepared_work.h"

#include "model/base/check.h"
#include "model/base/sort_by_digits.h"
#include "model/device/extents.h"
#include "model/work/depth_test_masks.h"
#include "model/work/draw_places.h"
#include "model/work/target_access.h"
#include "model/work/target_lookups.h"
#include "model/work/texel_lookups.h"
#include "model/work/tile_lines.h"
#include "model/work/traversal.h"

#include <algorithm>
#include <span>
#include <vector>

namespace ffgpu::work {
namespace {

ImageMemory image_memory(const DrawImageCommand& image) {
    if (image.width == 0 || image.height == 0) return {};
    DrawImageCommand row = image;
    row.height = 1;
    return {image.address, image_bytes(row), image.stride, image.height};
}

constexpr std::uint8_t AllLanes = 0xf;

// What the rasterizer makes: a quad of the command, or some of its lanes. In the order of their
// keys, then of their numbers, as one number.
class Ordered {
public:
    Ordered() = default;
    Ordered(std::uint64_t key, std::uint32_t quad, std::uint8_t lanes)
        : bits_(key << 36 | std::uint64_t{quad} << 4 | lanes) {}

    std::uint32_t key() const { return static_cast<std::uint32_t>(bits_ >> 36); }
    std::uint32_t quad() const { return static_cast<std::uint32_t>(bits_ >> 4); }
    std::uint8_t lanes() const { return bits_ & AllLanes; }
    bool operator<(const Ordered& other) const { return bits_ < other.bits_; }

private:
    std::uint64_t bits_ = 0;
};

// A quad as if it covered these lanes alone.
WorkQuad fragments_of(WorkQuad quad, std::uint8_t lanes) {
    for (std::uint8_t* mask : {&quad.covered,
                               &quad.after_early_depth,
                               &quad.after_coverage,
                               &quad.after_alpha,
                               &quad.after_stencil,
                               &quad.after_depth})
        *mask &= lanes;
    std::uint16_t samples = 0;
    for (unsigned lane = 0; lane < 4; ++lane)
        samples |= static_cast<std::uint16_t>((lanes >> lane & 1) != 0 ? 0xfu << 4 * lane : 0u);
    quad.samples_covered &= samples;
    quad.samples_written &= samples;
    return quad;
}

// For so many more, without a step for each few of them.
template <class T>
void make_room(std::vector<T>& items, std::size_t more) {
    const std::size_t wanted = items.size() + more;
    if (wanted > items.capacity()) items.reserve(std::max(wanted, 2 * items.capacity()));
}

class Appender {
public:
    Appender(const WholeCommand& command, const WorkConfig& config, PreparedScene& out)
        : command_(command)
        , config_(config)
        , out_(out)
        , draw_(out.draws.emplace_back())
        , draw_number_(static_cast<std::uint32_t>(out.draws.size() - 1))
        , test_(depth_test_place(command.draw, config.depth_test))
        , targets_(config, out)
        , texels_(command, config, out) {
        draw_.kind = command.draw.kind;
        draw_.number = command.draw.number;
        draw_.register_writes = command.draw.register_writes;
        draw_.register_words = command.draw.register_words;
        if (draw_.kind == WorkKind::Image) draw_.image = image_memory(command.draw.image);
        draw_.geometry = command.draw.geometry;
        draw_.geometry.primitives = {};
        draw_.geometry.pieces = {};
        draw_.first_primitive = static_cast<std::uint32_t>(out.primitives.size());
        draw_.state = command.draw.state;
        draw_.early_depth = test_.early;
        draw_.tests_twice = test_.twice;
        draw_.first_quad = static_cast<std::uint32_t>(out.quads.size());
        const std::size_t quads = command.quads.size();
        make_room(out.quads, quads);
        make_room(out.texture_parts, quads * command.units.size());
        make_room(out.target_lines, 2 * quads);
        make_room(out.target_bytes, 2 * quads);
    }

    void run(AddressMap& addresses) {
        if (command_.draw.state) place(*command_.draw.state, addresses);
        if (command_.has_values() && draw_.state) {
            draw_.has_values = true;
            draw_.value_kinds = QuadValueKinds::of(*draw_.state);
        }
        if (command_.draw.geometry.primitives.empty()) {
            add_untold_primitives();
        } else {
            add_primitives();
        }
        draw_.shape.add_quads(command_.quads);
        draw_.primitive_count =
            static_cast<std::uint32_t>(out_.primitives.size()) - draw_.first_primitive;
        draw_.quad_count = static_cast<std::uint32_t>(out_.quads.size()) - draw_.first_quad;
    }

private:
    // Where place_draw() tells the places.
    struct Places {
        Appender& to;
        const Registers& state;

        void texture(unsigned unit, const TextureLines& texture) const {
            to.texels_.place(unit, texture);
        }
        void depth(const PlacedLevel& place) const {
            const DepthAccess access = depth_access(state);
            to.targets_.place_depth(place, access);
            to.draw_.reads_depth = access.reads();
            to.draw_.writes_depth = access.writes();
            to.draw_.depth_place = place;
        }
        void color(std::uint8_t target, const PlacedLevel& place) const {
            const ColorAccess access = color_access(state, target);
            const PixelBytes whole = whole_pixel(state.targets.color[target].format);
            to.draw_.color_targets.push_back(target);
            to.draw_.reads_color |= access.reads;
            to.draw_.writes_color |= access.written.touched != 0;
            to.draw_.masks_color |= access.written.covered != whole.covered;
            to.targets_.place_color(place, access.written);
            to.draw_.color_places.push_back(place);
        }
    };

    void place(const Registers& state, AddressMap& addresses) {
        for (unsigned unit = 0; unit < TextureUnits; ++unit)
            draw_.combiners =
                static_cast<std::uint8_t>(draw_.combiners + state.combiners[unit].enable);
        const Places places{*this, state};
        place_draw(state, config_, addresses, places);
    }

    void add_primitives() {
        const GeometryWork& geometry = command_.draw.geometry;
        std::size_t quad = 0, piece = 0;
        std::uint32_t key = ~0u, number = 0; // of the piece, among those of its key
        for (const PrimitiveWork& primitive : geometry.primitives) {
            if (primitive.key != key) number = 0;
            key = primitive.key;
            begin_primitive({.last_vertex = primitive.last_vertex,
                             .planes = primitive.planes,
                             .fate = primitive.fate});
            for (std::uint32_t i = 0; i < primitive.pieces; ++i, ++number)
                quad = add_piece(quad, key, number, geometry.pieces[piece++]);
        }
        check(quad == command_.quads.size(), "each quad belongs to a primitive");
    }

    // An image has quads, but geometry had nothing to do with it.
    void add_untold_primitives() {
        const std::size_t vertices = command_.draw.geometry.vertices.size();
        const auto last = static_cast<std::uint32_t>(vertices == 0 ? 0 : vertices - 1);
        for (std::size_t quad = 0; quad < command_.quads.size();) {
            const WorkQuad& first = command_.quads[quad];
            if (quad == 0 || command_.quads[quad - 1].primitive != first.primitive)
                begin_primitive({.last_vertex = last});
            quad = add_piece(quad, first.primitive, first.piece, {});
        }
    }

    void begin_primitive(PreparedPrimitive primitive) {
        primitive.first_piece = static_cast<std::uint32_t>(out_.pieces.size());
        out_.primitives.push_back(primitive);
    }

    // Adds the piece with those of the quads from `begin` on that are its; returns the next one.
    std::size_t
    add_piece(std::size_t begin, std::uint32_t primitive, std::uint32_t number, PieceBox box) {
        const auto first = command_.quads.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = std::find_if(first, command_.quads.end(), [&](const WorkQuad& quad) {
            return quad.primitive != primitive || quad.piece != number;
        });
        const std::span quads(first, last);
        order_.clear();
        order_quads(quads, static_cast<std::uint32_t>(begin));
        sort_order();
        if (draw_.kind == WorkKind::Draw)
            draw_.shape.add_piece(quads, draw_.state && draw_.state->targets.samples() > 1);
        PreparedPiece piece{.begin = static_cast<std::uint32_t>(out_.quads.size()), .box = box};
        for (const Ordered& each : order_)
            add_quad(each.quad(), each.lanes());
        piece.end = static_cast<std::uint32_t>(out_.quads.size());
        walk_piece(config_.raster, piece, out_);
        out_.pieces.push_back(piece);
        ++out_.primitives.back().piece_count;
        return begin + quads.size();
    }

    // They come by rising numbers.
    void sort_order() {
        constexpr std::size_t Few = 256; // are compared: digits begin with a table of 2,048 places
        if (std::is_sorted(order_.begin(), order_.end())) return;
        if (order_.size() < Few) return std::sort(order_.begin(), order_.end());
        sort_by_digits(order_, spare_order_, [](const Ordered& each) { return each.key(); });
    }

    // As a whole, or fragment by fragment. The first quad's number is `number`.
    void order_quads(std::span<const WorkQuad> quads, std::uint32_t number) {
        const RasterOrder raster = config_.raster;
        for (const WorkQuad& quad : quads) {
            if (raster.granularity == Granularity::Quad)
                order_.emplace_back(traversal_key(raster, quad.x, quad.y), number, AllLanes);
            else
                order_fragments(quad, number);
            ++number;
        }
    }

    void order_fragments(const WorkQuad& quad, std::uint32_t number) {
        for (unsigned lane = 0; lane < 4; ++lane) {
            if ((quad.covered >> lane & 1) == 0) continue;
            const std::uint32_t x = quad.x + (lane & 1u), y = quad.y + (lane >> 1);
            order_.emplace_back(fragment_traversal_key(config_.raster, x, y),
                                number,
                                static_cast<std::uint8_t>(1u << lane));
        }
    }

    void add_quad(std::uint32_t number, std::uint8_t lanes) {
        const WorkQuad& whole = command_.quads[number];
        const WorkQuad from = lanes == AllLanes ? whole : fragments_of(whole, lanes);
        PreparedQuad& quad = out_.quads.emplace_back();
        quad.draw = draw_number_;
        quad.primitive = from.primitive;
        quad.piece = from.piece;
        quad.x = from.x;
        quad.y = from.y;
        quad.covered = from.covered;
        quad.after_early_depth = test_.after_early_test(from);
        quad.after_stencil = from.after_stencil;
        quad.after_depth = from.after_depth;
        quad.samples_written = from.samples_written;
        quad.after_alpha = from.after_alpha;
        targets_.add(test_.tested(from), quad);
        // With values, hidden fragments have texels, too.
        texels_.add(number, static_cast<std::uint8_t>(lanes & quad.after_early_depth), quad);
        if (draw_.has_values) add_values(number, lanes, quad);
    }

    // Of the lanes alone, where a quad is looked up by fragments.
    void add_values(std::uint32_t number, std::uint8_t lanes, PreparedQuad& quad) {
        const QuadValueKinds& kinds = draw_.value_kinds;
        const WorkQuad& from = command_.quads[number];
        QuadValues values;
        const bool fits = QuadValues::parse(kinds,
                                            covered_samples(from, kinds.multisampled),
                                            written_samples(from, kinds.multisampled),
                                            command_.values_of(number),
                                            values);
        check(fits, "a quad's values are those of its masks");
        quad.values_begin = static_cast<std::uint32_t>(out_.values.size());
        const auto add = [&](const SampleWords& words) {
            std::size_t next = 0;
            for_each_sample(words.samples, [&](unsigned lane, unsigned) {
                if (lanes >> lane & 1) out_.values.push_back(words.words[next]);
                ++next;
            });
        };
        unsigned samples = 0; // of the lanes
        for (unsigned lane = 0; lane < 4; ++lane)
            if (lanes >> lane & 1) samples |= 0xfu << 4 * lane;
        quad.samples_covered = static_cast<SampleBits>(from.samples_covered & samples);
        add(values.depths);
        if (kinds.tested_mask)
            out_.values.push_back(unsigned{values.depth_words.samples} & samples);
        add(values.depth_words);
        for (const SampleWords& words : values.colors)
            add(words);
        quad.value_count = static_cast<std::uint32_t>(out_.values.size()) - quad.values_begin;
    }

    const WholeCommand& command_;
    const WorkConfig& config_;
    PreparedScene& out_;
    PreparedDraw& draw_;
    const std::uint32_t draw_number_;
    const DepthTestPlace test_;
    TargetLookups targets_;
    TexelLookups texels_;
    std::vector<Ordered> order_, spare_order_; // of a piece
};

} // namespace

QuadValues PreparedScene::values_of(const PreparedQuad& quad) const {
    const QuadValueKinds& kinds = draws[quad.draw].value_kinds;
    const auto samples = [&](std::uint16_t of_samples, std::uint8_t lanes) {
        return kinds.multisampled ? of_samples : lanes_to_samples(lanes);
    };
    QuadValues parsed;
    const bool fits =
        QuadValues::parse(kinds,
                          samples(quad.samples_covered, quad.covered),
                          samples(quad.samples_written, quad.after_depth),
                          std::span(values).subspan(quad.values_begin, quad.value_count),
                          parsed);
    check(fits, "a quad's values are those of its masks");
    return parsed;
}

void append(const WholeCommand& command,
            const WorkConfig& config,
            AddressMap& addresses,
            PreparedScene& scene) {
    Appender(command, config, scene).run(addresses);
}

} // namespace ffgpu::work
