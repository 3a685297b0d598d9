// AccessPlane: one access each of some lanes of a batch, in structure-of-arrays form: what a vector
// stage stores at once, and what takes 10 bytes a lane where TexelAccess takes 16.

#pragma once

#include "model/base/chunk_memory.h"
#include "model/packets/fragment_batch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <utility>

namespace ffgpu {

// One access of one fragment to one level: 1 texel (nearest), 2x1 (1-D linear), 2x2 (linear), and
// twice that across two layers for 3-D linear. The texels are (x0|x1, y0|y1, layer0|layer1) after
// wrapping, counted in the stored image: from its border if it has one. Texels beyond the edge that
// the border colour stands for are marked by BorderTexel.
struct TexelAccess {
    static constexpr std::uint16_t BorderTexel = 0xffff;

    std::uint16_t lane;  // of the batch, or of the quad
    std::uint8_t level;  // of the image; 0 is its base level
    std::uint8_t linear; // bit 0: x0 and x1 both, bit 1: y0 and y1 both, bit 2: both layers
    std::uint16_t x0, x1, y0, y1;
    std::uint16_t layer0, layer1; // slice or face

    bool operator==(const TexelAccess&) const = default;
};

class AccessPlane {
public:
    // A word of two 16-bit numbers a lane, the second above the first.
    enum class Words { X, Y, Layers };

    using Memory = std::pmr::memory_resource*;

    AccessPlane() = default;
    explicit AccessPlane(Memory memory)
        : words_(memory) {}
    // Room for all lanes of `quads`, which is even. Without layers all are 0.
    AccessPlane(unsigned quads, bool has_layers, Memory memory)
        : quads_(quads)
        , words_(quads_ * (has_layers ? End : LayersAt), memory) {}

    FragmentMask lanes; // What other lanes hold means nothing.

    bool has_layers() const { return words_.size() > LayersAt * quads_; }
    // Each lane's, from lane 0 on; Layers only where it has them.
    std::uint32_t* words(Words which) { return words_.data() + place(which); }
    const std::uint32_t* words(Words which) const { return words_.data() + place(which); }
    // Level and, above it, TexelAccess::linear: 16 bits a lane, for vectors to load and store.
    std::uint16_t* heads() {
        return reinterpret_cast<std::uint16_t*>(words_.data() + HeadsAt * quads_);
    }
    const std::uint16_t* heads() const {
        return reinterpret_cast<const std::uint16_t*>(words_.data() + HeadsAt * quads_);
    }

    // An access is four words on a little endian host: its lane with the head above it, X, Y and
    // Layers.
    using AccessWords = std::array<std::uint32_t, 4>;

    TexelAccess at(unsigned lane) const { return std::bit_cast<TexelAccess>(words_at(lane, lane)); }
    // Of the batch's `lane`, which is told as `told_as`.
    AccessWords words_at(unsigned lane, unsigned told_as) const {
        std::uint16_t head;
        std::memcpy(&head, heads() + lane, sizeof head);
        return {told_as | std::uint32_t{head} << 16,
                words(Words::X)[lane],
                words(Words::Y)[lane],
                has_layers() ? words(Words::Layers)[lane] : 0};
    }

    // Room is made where there is none.
    void set(const AccessWords& words) {
        const auto head = static_cast<std::uint16_t>(words[0] >> 16);
        const unsigned lane = words[0] & 0xffff;
        const bool layers = words[3] != 0;
        if (lane / 4 >= quads_ || (layers && !has_layers())) make_room(lane / 4 + 1, layers);
        lanes.set(lane);
        std::uint32_t* const x = this->words(Words::X);
        std::uint32_t* const y = this->words(Words::Y);
        if (has_layers()) this->words(Words::Layers)[lane] = words[3];
        std::memcpy(heads() + lane, &head, sizeof head);
        x[lane] = words[1];
        y[lane] = words[2];
    }

private:
    // Where they begin, and where all end, in words a quad.
    static constexpr std::size_t XAt = 0, YAt = 4, HeadsAt = 8, LayersAt = 10, End = 14;

    void make_room(std::size_t quads, bool layers) {
        constexpr std::size_t Least = 8;
        const std::size_t room = quads <= quads_ ? quads_ : std::max({Least, quads, 2 * quads_});
        AccessPlane larger(
            static_cast<unsigned>(room), layers || has_layers(), words_.get_allocator().resource());
        const auto move = [&](std::size_t from, std::size_t end) {
            std::copy_n(words_.data() + from * quads_,
                        (end - from) * quads_,
                        larger.words_.data() + from * larger.quads_);
        };
        move(XAt, YAt);
        move(YAt, HeadsAt);
        move(HeadsAt, LayersAt);
        if (has_layers())
            move(LayersAt, End);
        else if (layers)
            std::fill_n(larger.words(Words::Layers), (End - LayersAt) * larger.quads_, 0u);
        larger.lanes = lanes;
        *this = std::move(larger);
    }

    std::size_t place(Words which) const {
        return quads_ * (which == Words::X ? XAt : which == Words::Y ? YAt : LayersAt);
    }

    std::size_t quads_ = 0;
    UnsetVector<std::uint32_t> words_;
};

} // namespace ffgpu
