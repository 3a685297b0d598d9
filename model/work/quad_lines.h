// QuadLines: the lines that hold the texels which the filters of one quad read, in the order of the
// reads.
//
// A quad's reads of one line are one look-up, as a chip that works in quads merges them. Without
// merging each read is a look-up, as the literature counts, save that reads of one line that follow
// each other are told once, which no cache can tell apart.

#pragma once

#include "model/packets/texel_footprint.h"
#include "model/work/level_lines.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

class QuadLines {
public:
    QuadLines(std::uint32_t line_bytes, bool merges)
        : line_bytes_(line_bytes)
        , merges_(merges)
        , lines_(64) {}

    void begin_quad() {
        count_ = reads_ = border_reads_ = 0, expands_blocks_ = false;
        last_ = {};
    }
    // What one fragment reads of one level.
    void add(const TextureLines& texture, const TexelAccess& access) {
        add(texture, std::bit_cast<AccessPlane::AccessWords>(access));
    }
    void add(const TextureLines& texture, const AccessPlane::AccessWords& access) {
        const std::uint32_t number = access[0] >> 16 & 0xff;
        const LevelLines* const level = texture.lines.data() + number;
        if (level >= texture.lines.data() + texture.lines.size()) return;
        if (is_last(*level, access)) // Most are.
            reads_ += 4;
        else
            add_other(texture, std::bit_cast<TexelAccess>(access));
    }
    // What several fragments read, 2x2 texels each: the lines in their order, some again, behind
    // make_room() for as many, and how many fragments. Where lines are merged.
    void make_room(std::size_t more) {
        if (count_ + more > lines_.size()) lines_.resize(2 * (count_ + more));
    }
    void add_texel(std::uint64_t line) { add_line(line); }
    void add_squares(std::uint32_t fragments) { reads_ += 4 * fragments; }

    std::span<const std::uint64_t> lines() const { return {lines_.data(), count_}; }
    std::uint32_t reads() const { return reads_; }               // texels
    std::uint32_t border_reads() const { return border_reads_; } // of the border's colour: no line
    bool expands_blocks() const { return expands_blocks_; }      // read from lines of blocks

private:
    static constexpr std::size_t MostOfAccess = 8;

    // The rectangles that were read last, of even and of odd levels: their lines are told.
    struct LastRead {
        const LevelLines* level = nullptr;
        std::uint16_t layer = 0;
        LevelLines::Rectangles rectangles{};
    };

    // Whether it reads 2x2 texels of the rectangles that were read last.
    bool is_last(const LevelLines& level, const AccessPlane::AccessWords& access) const {
        const LastRead& last = last_[access[0] >> 16 & 1]; // by its level
        const std::uint32_t linear = access[0] >> 24, layer0 = access[3] & 0xffff;
        return last.level == &level && linear == 3 && last.layer == layer0 &&
               last.rectangles == level.rectangles(access);
    }
    void add_other(const TextureLines& texture, const TexelAccess& access);

    void add_corners(const PlacedLevel& level, const TexelAccess& access);
    void add_line(std::uint64_t line) {
        std::uint64_t* const end = lines_.data() + count_;
        std::uint64_t* from = lines_.data();
        if (!merges_ && count_ > 0) from = end - 1;
        *end = line; // where the search ends
        while (*from != line)
            ++from;
        count_ += from == end;
    }

    std::uint32_t line_bytes_;
    bool merges_, expands_blocks_ = false;
    std::vector<std::uint64_t> lines_; // with room for what an access adds
    std::size_t count_ = 0;
    std::uint32_t reads_ = 0, border_reads_ = 0;
    std::array<LastRead, 2> last_; // none without merging
};

} // namespace ffgpu::work
