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

// 16 bits a lane.
std::uint64_t first_of(const PlaneRectangles& rectangles, unsigned quad) {
    std::uint64_t first;
    std::memcpy(&first, rectangles.first.data() + Lanes * quad, sizeof first);
    return first;
}

// Where the squares that a lane's quad reads lie; nowhere, if it reads no squares, or of a level
// without rectangles.
bool place(const AccessPlane& plane, const TextureLines& texture, unsigned lane, Block& block) {
    constexpr unsigned Square = 3; // TexelAccess::linear
    const unsigned head = plane.heads()[lane], level = head & 0xff;
    if (head >> 8 != Square || level >= texture.lines.size()) return false;
    block.level = &texture.lines[level];
    if (!block.level->has_tables() || !block.level->has_rectangles_of(texture.bits)) return false;
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
    for (const TexelFootprints& unit : batch.textures) {
        const TextureLines& texture = *textures[unit.unit];
        const std::size_t begin = plane_count_;
        for (const AccessPlane& accesses : unit.planes) {
            if (plane_count_ == planes_.size()) planes_.emplace_back();
            Plane& plane = planes_[plane_count_++];
            plane.accesses = &accesses;
            plane.live = accesses.lanes & lanes;
            if (unit.planes.size() <= MostPlanes)
                find_rectangles(accesses, plane.live, texture.bits, plane.rectangles);
        }
        units_.push_back({&texture, begin, plane_count_});
    }
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
        const std::uint64_t own = first_of(plane.rectangles, quad);
        const unsigned lane = Lanes * quad + static_cast<unsigned>(std::countr_zero(live));
        Block& block = blocks[i - unit.begin];
        if ((own & AllLanes * PlaneRectangles::Others) != 0) return false;
        if (!place(*plane.accesses, *unit.texture, lane, block)) return false;
        block.x = plane.rectangles.x[lane] & 0xffff;
        block.y = plane.rectangles.y[lane] & 0xffff;
        first |= own << Rectangles * (i - unit.begin);
        fragments += LiveLanes[live];
    }
    const RectangleBits step{step_of(unit.texture->bits.x), step_of(unit.texture->bits.y)};
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
