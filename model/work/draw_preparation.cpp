#include "model/work/draw_preparation.h"

#include "model/base/check.h"
#include "model/base/sort_by_digits.h"
#include "model/device/extents.h"
#include "model/work/draw_places.h"
#include "model/work/target_access.h"
#include "model/work/traversal.h"

#include <algorithm>

namespace ffgpu::work {
namespace {

constexpr std::uint8_t AllLanes = 0xf;

ImageMemory image_memory(const DrawImageCommand& image) {
    if (image.width == 0 || image.height == 0) return {};
    DrawImageCommand row = image;
    row.height = 1;
    return {image.address, image_bytes(row), image.stride, image.height};
}

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

} // namespace

DrawPreparation::DrawPreparation(const WholeCommand& command,
                                 const WorkConfig& config,
                                 AddressMap& addresses,
                                 PreparedScene& scene)
    : command_(command)
    , config_(config)
    , draw_number_(static_cast<std::uint32_t>(scene.draws.size()))
    , test_(depth_test_place(command.draw, config.depth_test))
    , targets_(config)
    , texels_(command, config) {
    PreparedDraw& draw = scene.draws.emplace_back();
    draw.kind = command.draw.kind;
    draw.number = command.draw.number;
    draw.register_writes = command.draw.register_writes;
    draw.register_words = command.draw.register_words;
    if (draw.kind == WorkKind::Image) draw.image = image_memory(command.draw.image);
    draw.geometry = command.draw.geometry;
    draw.geometry.primitives = {};
    draw.geometry.pieces = {};
    draw.first_primitive = static_cast<std::uint32_t>(scene.primitives.size());
    draw.state = command.draw.state;
    draw.early_depth = test_.early;
    draw.tests_twice = test_.twice;
    draw.first_quad = static_cast<std::uint32_t>(scene.quads.size());
    if (draw.state) place(*draw.state, addresses, draw);
    if (command.has_values() && draw.state) {
        draw.has_values = true;
        draw.value_kinds = QuadValueKinds::of(*draw.state);
        value_kinds_ = draw.value_kinds;
    }
    if (command.draw.geometry.primitives.empty()) {
        add_untold_primitives(scene, draw);
    } else {
        add_primitives(scene, draw);
    }
    draw.shape.add_quads(command.quads);
    draw.primitive_count =
        static_cast<std::uint32_t>(scene.primitives.size()) - draw.first_primitive;
    draw.quad_count = static_cast<std::uint32_t>(quads_left_);
}

// Where place_draw() tells the places.
struct DrawPreparation::Places {
    DrawPreparation& to;
    PreparedDraw& draw;
    const Registers& state;

    void texture(unsigned unit, const std::shared_ptr<const TextureLines>& texture) const {
        to.texels_.place(unit, texture);
    }
    void depth(const PlacedLevel& place) const {
        const DepthAccess access = depth_access(state);
        to.targets_.place_depth(place, access);
        draw.depth_bytes_read = access.bytes_read(state.targets.depth.format);
        draw.writes_depth = access.writes();
        draw.depth_place = place;
    }
    void color(std::uint8_t target, const PlacedLevel& place) const {
        const ColorAccess access = color_access(state, target);
        const PixelBytes whole = whole_pixel(state.targets.color[target].format);
        draw.color_targets.push_back(target);
        draw.reads_color |= access.reads;
        draw.writes_color |= access.written.touched != 0;
        draw.masks_color |= access.written.covered != whole.covered;
        to.targets_.place_color(place, access.written);
        draw.color_places.push_back(place);
    }
};

void DrawPreparation::place(const Registers& state, AddressMap& addresses, PreparedDraw& draw) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        draw.combiners = static_cast<std::uint8_t>(draw.combiners + state.combiners[unit].enable);
    const Places places{*this, draw, state};
    place_draw(state, config_, addresses, places);
}

void DrawPreparation::add_primitives(PreparedScene& scene, PreparedDraw& draw) {
    const GeometryWork& geometry = command_.draw.geometry;
    std::size_t quad = 0, piece = 0;
    std::uint32_t key = ~0u, number = 0; // of the piece, among those of its key
    for (const PrimitiveWork& primitive : geometry.primitives) {
        if (primitive.key != key) number = 0;
        key = primitive.key;
        scene.primitives.push_back({.last_vertex = primitive.last_vertex,
                                    .first_piece = static_cast<std::uint32_t>(scene.pieces.size()),
                                    .planes = primitive.planes,
                                    .fate = primitive.fate});
        for (std::uint32_t i = 0; i < primitive.pieces; ++i, ++number)
            quad = add_piece(quad, key, number, geometry.pieces[piece++], scene, draw);
    }
    check(quad == command_.quads.size(), "each quad belongs to a primitive");
}

// An image has quads, but geometry had nothing to do with it.
void DrawPreparation::add_untold_primitives(PreparedScene& scene, PreparedDraw& draw) {
    const std::size_t vertices = command_.draw.geometry.vertices.size();
    const auto last = static_cast<std::uint32_t>(vertices == 0 ? 0 : vertices - 1);
    for (std::size_t quad = 0; quad < command_.quads.size();) {
        const WorkQuad& first = command_.quads[quad];
        if (quad == 0 || command_.quads[quad - 1].primitive != first.primitive)
            scene.primitives.push_back(
                {.last_vertex = last,
                 .first_piece = static_cast<std::uint32_t>(scene.pieces.size())});
        quad = add_piece(quad, first.primitive, first.piece, {}, scene, draw);
    }
}

// Adds the piece with those of the quads from `begin` on that are its; returns the next one.
std::size_t DrawPreparation::add_piece(std::size_t begin,
                                       std::uint32_t primitive,
                                       std::uint32_t number,
                                       PieceBox box,
                                       PreparedScene& scene,
                                       PreparedDraw& draw) {
    const auto first = command_.quads.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = std::find_if(first, command_.quads.end(), [&](const WorkQuad& quad) {
        return quad.primitive != primitive || quad.piece != number;
    });
    const std::span quads(first, last);
    if (draw.kind == WorkKind::Draw)
        draw.shape.add_piece(quads, draw.state && draw.state->targets.samples() > 1);
    const std::uint32_t made = made_of(quads);
    if (made > 0)
        sources_.push_back({static_cast<std::uint32_t>(scene.pieces.size()),
                            static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(begin + quads.size()),
                            box});
    const auto place = static_cast<std::uint32_t>(draw.first_quad + quads_left_);
    scene.pieces.push_back(
        {.begin = place,
         .end = place + made,
         .box = box,
         .empty_blocks = made > 0 ? 0 : PieceWalk(config_.raster, box).empty_behind()});
    quads_left_ += made;
    ++scene.primitives.back().piece_count;
    return begin + quads.size();
}

// Quads that the rasterizer makes of these.
std::uint32_t DrawPreparation::made_of(std::span<const WorkQuad> quads) const {
    if (config_.raster.granularity == Granularity::Quad)
        return static_cast<std::uint32_t>(quads.size());
    int fragments = 0;
    for (const WorkQuad& quad : quads)
        fragments += std::popcount(quad.covered);
    return static_cast<std::uint32_t>(fragments);
}

void DrawPreparation::add_quads(std::size_t most, PreparedQuads& out, std::vector<PieceEnd>& ends) {
    const std::size_t added = std::min(most, quads_left_);
    make_room(out.quads, added);
    make_room(out.texture_parts, added * command_.units.size());
    make_room(out.target_lines, 2 * added);
    make_room(out.target_bytes, 2 * added);
    for (std::size_t i = 0; i < added; ++i, --quads_left_) {
        if (!walk_) begin_piece(sources_[next_source_++]);
        const Ordered& next = order_[next_in_order_++];
        add_quad(next.quad(), next.lanes(), out);
        walk_->come_to(out.quads.back());
        if (next_in_order_ < order_.size()) continue;
        ends.push_back({sources_[next_source_ - 1].piece, walk_->empty_behind()});
        walk_.reset();
    }
}

void DrawPreparation::begin_piece(const PieceSource& source) {
    walk_.emplace(config_.raster, source.box);
    order_.clear();
    next_in_order_ = 0;
    order_quads(std::span(command_.quads).subspan(source.begin, source.end - source.begin),
                source.begin);
    sort_order();
}

// They come by rising numbers.
void DrawPreparation::sort_order() {
    constexpr std::size_t Few = 256; // are compared: digits begin with a table of 2,048 places
    if (std::is_sorted(order_.begin(), order_.end())) return;
    if (order_.size() < Few) return std::sort(order_.begin(), order_.end());
    sort_by_digits(order_, spare_order_, [](const Ordered& each) { return each.key(); });
}

// As a whole, or fragment by fragment. The first quad's number is `number`.
void DrawPreparation::order_quads(std::span<const WorkQuad> quads, std::uint32_t number) {
    const RasterOrder raster = config_.raster;
    for (const WorkQuad& quad : quads) {
        if (raster.granularity == Granularity::Quad)
            order_.emplace_back(traversal_key(raster, quad.x, quad.y), number, AllLanes);
        else
            order_fragments(quad, number);
        ++number;
    }
}

void DrawPreparation::order_fragments(const WorkQuad& quad, std::uint32_t number) {
    for (unsigned lane = 0; lane < 4; ++lane) {
        if ((quad.covered >> lane & 1) == 0) continue;
        const std::uint32_t x = quad.x + (lane & 1u), y = quad.y + (lane >> 1);
        order_.emplace_back(fragment_traversal_key(config_.raster, x, y),
                            number,
                            static_cast<std::uint8_t>(1u << lane));
    }
}

void DrawPreparation::add_quad(std::uint32_t number, std::uint8_t lanes, PreparedQuads& out) {
    const WorkQuad& whole = command_.quads[number];
    const WorkQuad from = lanes == AllLanes ? whole : fragments_of(whole, lanes);
    PreparedQuad& quad = out.quads.emplace_back();
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
    targets_.add(test_.tested(from), quad, out);
    // With values, hidden fragments have texels, too.
    texels_.add(number, static_cast<std::uint8_t>(lanes & quad.after_early_depth), quad, out);
    if (value_kinds_) add_values(number, lanes, quad, out);
}

// Of the lanes alone, where a quad is looked up by fragments.
void DrawPreparation::add_values(std::uint32_t number,
                                 std::uint8_t lanes,
                                 PreparedQuad& quad,
                                 PreparedQuads& out) {
    const QuadValueKinds& kinds = *value_kinds_;
    const WorkQuad& from = command_.quads[number];
    QuadValues values;
    const bool fits = QuadValues::parse(kinds,
                                        covered_samples(from, kinds.multisampled),
                                        written_samples(from, kinds.multisampled),
                                        command_.values_of(number),
                                        values);
    check(fits, "a quad's values are those of its masks");
    quad.values_begin = static_cast<std::uint32_t>(out.values.size());
    const auto add = [&](const SampleWords& words) {
        std::size_t next = 0;
        for_each_sample(words.samples, [&](unsigned lane, unsigned) {
            if (lanes >> lane & 1) out.values.push_back(words.words[next]);
            ++next;
        });
    };
    unsigned samples = 0; // of the lanes
    for (unsigned lane = 0; lane < 4; ++lane)
        if (lanes >> lane & 1) samples |= 0xfu << 4 * lane;
    quad.samples_covered = static_cast<SampleBits>(from.samples_covered & samples);
    add(values.depths);
    if (kinds.tested_mask) out.values.push_back(unsigned{values.depth_words.samples} & samples);
    add(values.depth_words);
    for (const SampleWords& words : values.colors)
        add(words);
    quad.value_count = static_cast<std::uint32_t>(out.values.size()) - quad.values_begin;
}

} // namespace ffgpu::work
