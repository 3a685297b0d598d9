#include "model/work/batch_reads.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace ffgpu::work {
namespace {

constexpr unsigned Lanes = 4, Rectangles = 4;
constexpr unsigned MostPlanes = 4; // whose rectangles of a lane have 16 bits
constexpr std::array<std::uint8_t, 16> LiveLanes{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

// From a rectangle's first texel to that of the next one.
std::uint16_t step_of(std::uint16_t bits) {
    return static_cast<std::uint16_t>(-bits);
}

// Of one plane's four rectangles of a quad.
struct Block {
    const LevelLines* level;
    std::uint64_t layer; // as LevelLines::layer() has it
    std::uint32_t x, y;

    std::uint64_t line(unsigned rectangle, const RectangleBits& step) const {
        const std::uint64_t column = level->column(x + (rectangle & 1) * step.x);
        const std::uint64_t row = level->row(y + (rectangle >> 1) * step.y);
        return level->line(layer + row + column);
    }
};

constexpr std::uint64_t AllLanes = 0x1000100010001;

// 16 bits a lane, as PlaneRectangles::first has them.
bool has_others(std::uint64_t first) {
    return (first & AllLanes * PlaneRectangles::Others) != 0;
}
std::uint64_t first_of(const PlaneRectangles& rectangles, unsigned quad) {
    std::uint64_t first;
    std::memcpy(&first, rectangles.first.data() + Lanes * quad, sizeof first);
    return first;
}

// Quads of which lanes read first the same rectangles, of the same level and layers, as those of
// the quad before, a bit each.
std::uint64_t find_repeats(const PlaneRectangles& rectangles,
                           const AccessPlane& plane,
                           const FragmentMask& live) {
    const std::uint16_t* const heads = plane.heads();
    const std::uint32_t* const layers =
        plane.has_layers() ? plane.words(AccessPlane::Words::Layers) : nullptr;
    std::uint64_t repeats = 0;
    unsigned lanes_before = live.quad(0);
    for (unsigned quad = 1; quad < BatchQuads; ++quad) {
        const unsigned lanes = live.quad(quad), both = lanes & lanes_before;
        const unsigned own = Lanes * quad, before = own - Lanes;
        bool same = lanes == lanes_before; // If there are none in both, there have to be none.
        lanes_before = lanes;
        if (both != 0) {
            const auto lane = static_cast<unsigned>(std::countr_zero(both));
            const std::uint64_t first = first_of(rectangles, quad);
            same = first == first_of(rectangles, quad - 1) && !has_others(first) &&
                   rectangles.x[own] == rectangles.x[before] &&
                   rectangles.y[own] == rectangles.y[before] &&
                   heads[own + lane] == heads[before + lane] &&
                   (!layers || layers[own + lane] == layers[before + lane]);
        }
        repeats |= std::uint64_t{same} << quad;
    }
    return repeats;
}

// Where the squares that a lane's quad reads lie; nowhere, if it reads no squares, or of a level
// without rectangles.
bool place(const AccessPlane& plane, const TextureLines& texture, unsigned lane, Block& block) {
    constexpr unsigned Square = 3; // TexelAccess::linear
    const unsigned head = plane.heads()[lane], level = head & 0xff;
    constexpr unsigned Levels = 32;
    if (head >> 8 != Square || level >= Levels || (texture.in_rectangles >> level & 1) == 0)
        return false;
    block.level = &texture.lines[level];
    const std::uint32_t layers =
        plane.has_layers() ? plane.words(AccessPlane::Words::Layers)[lane] : 0;
    if ((layers & 0xffff) == TexelAccess::BorderTexel) return false;
    block.layer = block.level->layer(layers & 0xffff);
    return true;
}

// The rectangles of one quad.
struct QuadRectangles {
    std::uint16_t x = 0xffff, y = 0xffff;
    std::array<std::uint16_t, Lanes> first{};
};

// Which of two rectangles beside each other two texels lie in: bit 0 the one at `least`, bit 1 the
// next; nothing, where they lie in others or come from right to left.
unsigned sides(std::uint16_t from, std::uint16_t to, std::uint16_t least, std::uint16_t bits) {
    const auto side = [&](std::uint16_t at) -> unsigned {
        if ((at & 0x8000) != 0) return 0; // the border
        const auto on = static_cast<std::uint16_t>((at & bits) - least);
        return on == 0 ? 1 : on == step_of(bits) ? 2 : 0;
    };
    const unsigned first = side(from), second = side(to);
    return first == 0 || second == 0 || first > second ? 0 : first | second;
}

QuadRectangles
rectangles_of(const AccessPlane& plane, const RectangleBits& bits, unsigned quad, unsigned live) {
    QuadRectangles found;
    const auto least = [](std::uint16_t& to, unsigned at) {
        to = std::min(to, static_cast<std::uint16_t>(at));
    };
    const TexelAccess one = plane.at(Lanes * quad + static_cast<unsigned>(std::countr_zero(live)));
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        if ((live >> lane & 1) == 0) continue;
        const TexelAccess access = plane.at(Lanes * quad + lane);
        least(found.x, access.x0 & bits.x), least(found.x, access.x1 & bits.x);
        least(found.y, access.y0 & bits.y), least(found.y, access.y1 & bits.y);
    }
    unsigned seen = 0;
    for (unsigned lane = 0; lane < Lanes; ++lane) {
        if ((live >> lane & 1) == 0) continue;
        const TexelAccess access = plane.at(Lanes * quad + lane);
        const unsigned x = sides(access.x0, access.x1, found.x, bits.x);
        const unsigned y = sides(access.y0, access.y1, found.y, bits.y);
        const bool same = access.level == one.level && access.linear == one.linear &&
                          access.layer0 == one.layer0 && access.layer1 == one.layer1;
        if (x == 0 || y == 0 || !same) {
            found.first.fill(PlaneRectangles::Others);
            return found;
        }
        const unsigned read = (y & 1 ? x : 0) | (y & 2 ? x << 2 : 0);
        found.first[lane] = static_cast<std::uint16_t>(read & ~seen);
        seen |= read;
    }
    return found;
}

// The texels of a lane's square, x0, x1, y0 and y1, 16 bits each; and the same four of one number
// for each axis.
std::uint64_t texels_of(const AccessPlane& plane, unsigned lane) {
    return std::uint64_t{plane.words(AccessPlane::Words::Y)[lane]} << 32 |
           plane.words(AccessPlane::Words::X)[lane];
}
std::uint64_t four_of(std::uint16_t x, std::uint16_t y) {
    return std::uint64_t{y * 0x10001u} << 32 | x * 0x10001u;
}

// A level seen with its last texels to the left of its first ones, or below, along the axes along
// which a lane reads from the last to the first, as where a texture repeats.
struct Turned {
    std::uint16_t x = 0, y = 0; // half of the level's texels; 0: seen as it is
    std::uint64_t halves, inside;

    Turned(const LevelLines& level, std::uint64_t backwards)
        : x(static_cast<std::uint16_t>(backwards & 1 ? level.columns() / 2 : 0))
        , y(static_cast<std::uint16_t>(backwards & 2 ? level.rows() / 2 : 0))
        , halves(four_of(x, y))
        , inside(four_of(static_cast<std::uint16_t>(2 * x - 1),
                         static_cast<std::uint16_t>(2 * y - 1))) {}

    std::uint64_t operator()(std::uint64_t texels) const { return (texels + halves) & inside; }
};

// Bit 0: from right to left; bit 1: downwards.
unsigned backwards_of(std::uint64_t texels) {
    const auto part = [&](unsigned at) { return texels >> at & 0xffff; };
    return (part(16) < part(0) ? 1u : 0u) | (part(48) < part(32) ? 2u : 0u);
}

// The block and what lanes read first of a quad with others, if these are rectangles in a level
// that is seen turned. Returns whether they are.
bool turn_round(const AccessPlane& plane,
                const RectangleBits& bits,
                unsigned quad,
                unsigned live,
                Block& block,
                std::uint64_t& first) {
    constexpr std::uint64_t Border = 0x8000 * AllLanes;
    const unsigned one = Lanes * quad + static_cast<unsigned>(std::countr_zero(live));
    std::array<std::uint64_t, Lanes> texels{};
    unsigned backwards = 0;
    for (unsigned left = live; left != 0; left &= left - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(left));
        const unsigned at = Lanes * quad + lane;
        texels[lane] = texels_of(plane, at);
        backwards |= backwards_of(texels[lane]);
        if (plane.heads()[at] != plane.heads()[one] || (texels[lane] & Border) != 0) return false;
        if (plane.has_layers() && plane.words(AccessPlane::Words::Layers)[at] !=
                                      plane.words(AccessPlane::Words::Layers)[one])
            return false;
    }
    if (backwards == 0) return false;
    const Turned turned(*block.level, backwards);
    const std::uint64_t firsts = four_of(bits.x, bits.y);
    std::uint64_t x = 0xffff, y = 0xffff;
    for (unsigned left = live; left != 0; left &= left - 1) {
        std::uint64_t& own = texels[static_cast<unsigned>(std::countr_zero(left))];
        own = turned(own) & firsts;
        x = std::min({x, own & 0xffff, own >> 16 & 0xffff});
        y = std::min({y, own >> 32 & 0xffff, own >> 48});
    }
    const std::uint64_t least =
        four_of(static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y));
    const std::uint64_t steps = four_of(step_of(bits.x), step_of(bits.y)); // a bit each
    unsigned seen = 0;
    first = 0;
    for (unsigned left = live; left != 0; left &= left - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(left));
        const std::uint64_t on = texels[lane] - least;
        if ((on & ~steps) != 0 || backwards_of(on) != 0) return false;
        const unsigned columns = (on & 0xffff ? 0u : 1u) | (on >> 16 & 0xffff ? 2u : 0u);
        const unsigned read = (on >> 32 & 0xffff ? 0 : columns) | (on >> 48 ? columns << 2 : 0);
        first |= std::uint64_t{read & ~seen} << 16 * lane;
        seen |= read;
    }
    block.x =
        static_cast<std::uint32_t>(x) + turned.x; // Tables tell of texels beyond the edge, too.
    block.y = static_cast<std::uint32_t>(y) + turned.y;
    return true;
}

} // namespace

void find_rectangles_plainly(const AccessPlane& plane,
                             const FragmentMask& live,
                             const RectangleBits& bits,
                             PlaneRectangles& found) {
    for (unsigned quad = 0; quad < BatchQuads; ++quad) {
        if (live.quad(quad) == 0) continue;
        const QuadRectangles of_quad = rectangles_of(plane, bits, quad, live.quad(quad));
        for (unsigned lane = 0; lane < Lanes; ++lane) {
            found.first[Lanes * quad + lane] = of_quad.first[lane];
            found.x[Lanes * quad + lane] = of_quad.x * 0x10001u;
            found.y[Lanes * quad + lane] = of_quad.y * 0x10001u;
        }
    }
}

void BatchReads::set(const WorkBatch& batch,
                     const FragmentMask& lanes,
                     std::span<const TextureLines* const> textures) {
    units_.clear();
    plane_count_ = 0;
    before_ = None;
    repeats_ = ~std::uint64_t{0};
    for (const TexelFootprints& unit : batch.textures) {
        const TextureLines& texture = *textures[unit.unit];
        const std::size_t begin = plane_count_;
        for (const AccessPlane& accesses : unit.planes) {
            if (plane_count_ == planes_.size()) planes_.emplace_back();
            Plane& plane = planes_[plane_count_++];
            plane.accesses = &accesses;
            plane.live = accesses.lanes & lanes;
            if (unit.planes.size() > MostPlanes) {
                repeats_ = 0;
                continue;
            }
            find_rectangles(accesses, plane.live, texture.bits, plane.rectangles);
            repeats_ &= find_repeats(plane.rectangles, accesses, plane.live);
        }
        units_.push_back({&texture, begin, plane_count_});
    }
}

void BatchReads::add_quad(unsigned quad, QuadLines& lines) {
    bool in_rectangles = true;
    for (const Unit& unit : units_) {
        if (add_rectangles(unit, quad, lines)) continue;
        add_each(unit, quad, lines);
        in_rectangles = false;
    }
    before_ = in_rectangles && !lines.lines().empty() ? quad : None;
}

std::uint32_t BatchReads::reads(unsigned quad) const {
    std::uint32_t fragments = 0;
    for (std::size_t i = 0; i < plane_count_; ++i)
        fragments += LiveLanes[planes_[i].live.quad(quad)];
    return 4 * fragments;
}

// Lane after lane, of each the planes in their order. Returns whether it has added all.
bool BatchReads::add_rectangles(const Unit& unit, unsigned quad, QuadLines& lines) const {
    if (unit.end - unit.begin > MostPlanes) return false;
    std::array<Block, MostPlanes> blocks;
    std::uint64_t first = 0; // a lane's 16 bits, a plane's four
    std::uint32_t fragments = 0;
    for (std::size_t i = unit.begin; i < unit.end; ++i) {
        const Plane& plane = planes_[i];
        const unsigned live = plane.live.quad(quad);
        if (live == 0) continue;
        std::uint64_t own = first_of(plane.rectangles, quad);
        const unsigned lane = Lanes * quad + static_cast<unsigned>(std::countr_zero(live));
        Block& block = blocks[i - unit.begin];
        if (!place(*plane.accesses, *unit.texture, lane, block)) return false;
        block.x = plane.rectangles.x[lane] & 0xffff;
        block.y = plane.rectangles.y[lane] & 0xffff;
        if (has_others(own) &&
            !turn_round(*plane.accesses, unit.texture->bits, quad, live, block, own))
            return false;
        first |= own << Rectangles * (i - unit.begin);
        fragments += LiveLanes[live];
    }
    const RectangleBits step{step_of(unit.texture->bits.x), step_of(unit.texture->bits.y)};
    lines.make_room(MostPlanes * Rectangles * Lanes);
    for (; first != 0; first &= first - 1) {
        const auto at = static_cast<unsigned>(std::countr_zero(first));
        lines.add_texel(blocks[at / Rectangles % MostPlanes].line(at % Rectangles, step));
    }
    lines.add_squares(fragments);
    return true;
}

void BatchReads::add_each(const Unit& unit, unsigned quad, QuadLines& lines) const {
    for (unsigned lane = 0; lane < Lanes; ++lane)
        for (std::size_t plane = unit.begin; plane < unit.end; ++plane)
            if ((planes_[plane].live.quad(quad) >> lane & 1) != 0)
                lines.add(*unit.texture, planes_[plane].accesses->at(Lanes * quad + lane));
}

} // namespace ffgpu::work
