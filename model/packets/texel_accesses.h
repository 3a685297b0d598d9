// TexelAccesses: what quads read of textures, quad after quad. A filter reads neighbours, and the
// lanes of a quad read one level: most accesses are told by the place of their first texel, a word
// each, and what they have in common. Others are kept as they are.

#pragma once

#include "model/packets/texel_access.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

// What a quad's regular accesses have in common: each of its lanes has one of `level`, or that and
// then one of the next level; in all of them the second texels and layers are the first ones'
// neighbours, where the filter reads two at all; and none is the border colour's.
struct RegularAccesses {
    std::uint8_t lanes = 0;  // bit i: lane i has accesses
    std::uint8_t linear = 0; // TexelAccess::linear
    std::uint8_t level = 0;
    std::uint8_t layer = 0; // the first
    bool next_level = false;

    unsigned count() const {
        constexpr std::uint64_t LanesOfMask = 0x4332322132212110; // four bits each
        return static_cast<unsigned>(LanesOfMask >> 4 * lanes & 7) << (next_level ? 1 : 0);
    }
    // The access of a lane whose first texel is at `place` of `level`.
    TexelAccess access(std::uint16_t lane, std::uint8_t of_level, std::uint32_t place) const {
        const auto half = [](std::uint32_t value) { return static_cast<std::uint16_t>(value); };
        const std::uint32_t x = place & 0xffff, y = place >> 16;
        return {.lane = lane,
                .level = of_level,
                .linear = linear,
                .x0 = half(x),
                .x1 = half(x + (linear & 1u)),
                .y0 = half(y),
                .y1 = half(y + (linear >> 1 & 1u)),
                .layer0 = layer,
                .layer1 = half(layer + (linear >> 2 & 1u))};
    }
};

class TexelAccesses {
public:
    // Of an access: its first texel's column, and its row above that.
    using Place = std::uint32_t;

private:
    using Word = std::uint32_t;
    static constexpr std::size_t WordsOfAccess = sizeof(TexelAccess) / sizeof(Word);

    struct Quad {
        std::uint32_t begin = 0; // of its words: places, or accesses
        std::uint8_t form = 0;   // lanes of regular ones, NextLevel, Irregular
        std::uint8_t linear = 0, level = 0, layer = 0;
    };
    static constexpr std::uint8_t Lanes = 0xf, NextLevel = 0x10, Irregular = 0x20;

public:
    // The accesses of a quad. They live as long as the list, up to its next change.
    class OfQuad {
    public:
        std::size_t size() const {
            return is_regular() ? words_.size() : words_.size() / WordsOfAccess;
        }
        bool is_regular() const { return (quad_.form & Irregular) == 0; }
        // Of regular ones. Places are lane by lane, the finer level first.
        RegularAccesses common() const {
            return {static_cast<std::uint8_t>(quad_.form & Lanes),
                    quad_.linear,
                    quad_.level,
                    quad_.layer,
                    (quad_.form & NextLevel) != 0};
        }
        std::span<const Place> places() const { return words_; }

        // Calls each(access) in their order. Lanes are those of the quad.
        template <class Each>
        void for_each(Each&& each) const {
            if (!is_regular()) {
                for (std::size_t at = 0; at < words_.size(); at += WordsOfAccess)
                    each(access_at(words_.data() + at));
                return;
            }
            const RegularAccesses all = common();
            const Word* place = words_.data();
            for (std::uint16_t lane = 0; lane < 4; ++lane) {
                if ((all.lanes >> lane & 1) == 0) continue;
                each(all.access(lane, all.level, *place++));
                if (all.next_level)
                    each(all.access(lane, static_cast<std::uint8_t>(all.level + 1), *place++));
            }
        }
        std::vector<TexelAccess> all() const {
            std::vector<TexelAccess> list;
            for_each([&](const TexelAccess& access) { list.push_back(access); });
            return list;
        }

    private:
        friend class TexelAccesses;
        Quad quad_;
        std::span<const Word> words_;
    };

    std::size_t quads() const { return quads_.size(); }
    // No quad has any.
    bool empty() const { return words_.empty(); }
    // Accesses of all quads.
    std::size_t count() const;

    // Quads behind the last one have none.
    OfQuad of(std::size_t number) const {
        OfQuad quad;
        if (number >= quads_.size()) return quad;
        quad.quad_ = quads_[number];
        quad.words_ = std::span(words_).subspan(quad.quad_.begin, words_of(number));
        return quad;
    }

    // Appends a quad: of each access the lane counts modulo 4. They may stand in any order.
    void add(std::span<const TexelAccess> accesses);
    void add(const RegularAccesses& common, const Place* places) {
        quads_.push_back(regular_quad(common, words_.size()));
        words_.insert(words_.end(), places, places + common.count());
    }
    // The same of `count` quads, of common.count() places each.
    void add(std::size_t count, const RegularAccesses& common, const Place* places) {
        for (std::size_t i = 0; i < count; ++i)
            quads_.push_back(regular_quad(common, words_.size() + i * common.count()));
        words_.insert(words_.end(), places, places + count * common.count());
    }
    void add(const OfQuad& quad) {
        quads_.push_back(quad.quad_);
        quads_.back().begin = static_cast<std::uint32_t>(words_.size());
        words_.insert(words_.end(), quad.words_.begin(), quad.words_.end());
    }
    // For as many quads as there are, and those of `other`.
    void make_room(std::size_t quads, std::size_t words) {
        quads_.reserve(quads_.size() + quads);
        words_.reserve(words_.size() + words);
    }
    std::size_t words() const { return words_.size(); }
    // Of quads first .. end - 1: at least as many as they have accesses.
    std::size_t words(std::size_t first, std::size_t end) const {
        const auto at = [this](std::size_t quad) {
            return quad < quads_.size() ? quads_[quad].begin : words_.size();
        };
        return at(end) - at(first);
    }
    void clear() {
        quads_.clear();
        words_.clear();
    }

    // The same accesses, however they are kept.
    bool operator==(const TexelAccesses& other) const;

private:
    static Quad regular_quad(const RegularAccesses& common, std::size_t begin) {
        const unsigned form = common.lanes | (common.next_level ? NextLevel : 0u);
        return {static_cast<std::uint32_t>(begin),
                static_cast<std::uint8_t>(form),
                common.linear,
                common.level,
                common.layer};
    }
    static TexelAccess access_at(const Word* words) {
        return std::bit_cast<TexelAccess>(
            std::array<Word, WordsOfAccess>{words[0], words[1], words[2], words[3]});
    }
    std::size_t words_of(std::size_t number) const {
        const std::size_t end =
            number + 1 < quads_.size() ? quads_[number + 1].begin : words_.size();
        return end - quads_[number].begin;
    }

    static RegularAccesses common_of(std::span<const TexelAccess> accesses);
    static bool reads_border(const TexelAccess& access) {
        constexpr std::uint16_t Border = TexelAccess::BorderTexel;
        return access.x0 == Border || access.x1 == Border || access.y0 == Border ||
               access.y1 == Border;
    }
    static Place place_of(const TexelAccess& access) {
        return static_cast<Place>(access.y0) << 16 | access.x0;
    }

    std::vector<Quad> quads_;
    std::vector<Word> words_;
};

inline std::size_t TexelAccesses::count() const {
    std::size_t sum = 0;
    for (std::size_t quad = 0; quad < quads_.size(); ++quad)
        sum += of(quad).size();
    return sum;
}

// What the accesses have in common if they are regular, from their first ones.
inline RegularAccesses TexelAccesses::common_of(std::span<const TexelAccess> accesses) {
    RegularAccesses common;
    if (accesses.empty()) return common;
    for (const TexelAccess& access : accesses)
        common.lanes |= static_cast<std::uint8_t>(1u << access.lane % 4);
    common.linear = accesses[0].linear;
    common.level = accesses[0].level;
    common.layer = static_cast<std::uint8_t>(accesses[0].layer0);
    common.next_level = accesses.size() > 1 && accesses[0].lane == accesses[1].lane;
    return common;
}

inline void TexelAccesses::add(std::span<const TexelAccess> accesses) {
    const RegularAccesses common = common_of(accesses);
    const std::size_t begin = words_.size();
    for (const TexelAccess& access : accesses)
        words_.push_back(place_of(access));
    quads_.push_back(regular_quad(common, begin));
    std::size_t next = 0;
    bool same = accesses.size() == common.count();
    const auto compare = [&](const TexelAccess& kept) {
        TexelAccess access = accesses[next++];
        access.lane %= 4;
        same = same && kept == access && !reads_border(access);
    };
    if (same) of(quads_.size() - 1).for_each(compare);
    if (same) return;
    words_.resize(begin);
    quads_.back().form = Irregular;
    for (TexelAccess access : accesses) {
        access.lane %= 4;
        const auto words = std::bit_cast<std::array<Word, WordsOfAccess>>(access);
        words_.insert(words_.end(), words.begin(), words.end());
    }
}

inline bool TexelAccesses::operator==(const TexelAccesses& other) const {
    for (std::size_t quad = 0; quad < std::max(quads(), other.quads()); ++quad)
        if (of(quad).all() != other.of(quad).all()) return false;
    return true;
}

} // namespace ffgpu
