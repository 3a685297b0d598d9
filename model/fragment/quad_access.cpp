#include "model/fragment/quad_access.h"

#include "model/base/check.h"
#include "model/fragment/quad_rows.h"
#include "model/memory/pixel_format.h"

#include <bit>

namespace ffgpu {
namespace {

// Two pixels side by side as one word, and as two words of an array.
template <class Pixel>
struct Row;

template <>
struct Row<std::uint32_t> {
    using Word = std::uint64_t;
    static constexpr std::array<Word, 4> Masks{
        0, 0xffffffff, 0xffffffff00000000, 0xffffffffffffffff};

    static Word join(const std::uint32_t* pixels) {
        Word row;
        std::memcpy(&row, pixels, sizeof row);
        return row;
    }
    static void split(Word row, std::uint32_t* pixels) { std::memcpy(pixels, &row, sizeof row); }
};

template <>
struct Row<std::uint16_t> {
    using Word = std::uint32_t;
    static constexpr std::array<Word, 4> Masks{0, 0xffff, 0xffff0000, 0xffffffff};

    static Word join(const std::uint32_t* pixels) { return (pixels[0] & 0xffff) | pixels[1] << 16; }
    static void split(Word row, std::uint32_t* pixels) {
        pixels[0] = row & 0xffff;
        pixels[1] = row >> 16;
    }
};

template <>
struct Row<std::uint8_t> {
    using Word = std::uint16_t;
    static constexpr std::array<Word, 4> Masks{0, 0xff, 0xff00, 0xffff};

    static Word join(const std::uint32_t* pixels) {
        return static_cast<Word>((pixels[0] & 0xff) | (pixels[1] & 0xff) << 8);
    }
    static void split(Word row, std::uint32_t* pixels) {
        pixels[0] = row & 0xffu;
        pixels[1] = row >> 8;
    }
};

// A surface with pixels of one size, and the places of a batch's quads in it.
template <class Pixel, class Byte>
class QuadSurface {
public:
    using Pair = Row<Pixel>;
    using Word = typename Pair::Word;

    QuadSurface(const Surface& surface, std::span<Byte> memory, const FragmentBatch& batch)
        : base_(memory.data() + surface.address)
        , stride_(surface.stride)
        , width_(surface.width)
        , height_(surface.height)
        , even_((width_ | height_) % 2 == 0)
        , batch_(batch) {}

    PixelRows<Byte> rows() const { return {base_, stride_}; }

    Byte* lower_row(unsigned q) const {
        return base_ + batch_.y[q] * stride_ + batch_.x[q] * sizeof(Pixel);
    }

    bool even() const { return even_; }

    // Neither the right nor the upper half of the quad is outside.
    bool is_whole(unsigned q) const {
        return even_ || (batch_.x[q] + 1u < width_ && batch_.y[q] + 1u < height_);
    }

    void load_row(unsigned q, std::uint32_t* pixels) const {
        const Byte* const lower = lower_row(q);
        for (unsigned i = 0; i < RowQuads; ++i) {
            Pair::split(load_word<Word>(lower + i * sizeof(Word)), pixels + 4 * i);
            Pair::split(load_word<Word>(lower + stride_ + i * sizeof(Word)), pixels + 4 * i + 2);
        }
    }

    void store_row(unsigned q, const std::uint32_t* pixels) const {
        Byte* const lower = lower_row(q);
        for (unsigned i = 0; i < RowQuads; ++i) {
            store_word(lower + i * sizeof(Word), Pair::join(pixels + 4 * i));
            store_word(lower + stride_ + i * sizeof(Word), Pair::join(pixels + 4 * i + 2));
        }
    }

    void load(unsigned q, std::uint32_t* pixels) const {
        const Byte* row = lower_row(q);
        Pair::split(load_word<Word>(row), pixels);
        Pair::split(load_word<Word>(row + stride_), pixels + 2);
    }

    void store(unsigned q, const std::uint32_t* pixels) const {
        Byte* row = lower_row(q);
        store_word(row, Pair::join(pixels));
        store_word(row + stride_, Pair::join(pixels + 2));
    }

    void store_masked(unsigned q, unsigned lanes, const std::uint32_t* pixels) const {
        Byte* row = lower_row(q);
        merge(row, Pair::Masks[lanes & 3], Pair::join(pixels));
        merge(row + stride_, Pair::Masks[lanes >> 2], Pair::join(pixels + 2));
    }

    void load_pixels(unsigned q, unsigned lanes, std::uint32_t* pixels) const {
        for (unsigned i = 0; i < 4; ++i)
            if ((lanes >> i & 1) != 0) pixels[i] = load_word<Pixel>(pixel(q, i));
    }

    void store_pixels(unsigned q, unsigned lanes, const std::uint32_t* pixels) const {
        for (unsigned i = 0; i < 4; ++i)
            if ((lanes >> i & 1) != 0) store_word(pixel(q, i), static_cast<Pixel>(pixels[i]));
    }

private:
    Byte* pixel(unsigned q, unsigned i) const {
        return lower_row(q) + (i >> 1) * stride_ + (i & 1) * sizeof(Pixel);
    }

    static void merge(Byte* at, Word mask, Word row) {
        store_word(at, static_cast<Word>((load_word<Word>(at) & ~mask) | (row & mask)));
    }

    Byte* base_;
    std::size_t stride_;
    unsigned width_, height_;
    bool even_; // then every quad is whole
    const FragmentBatch& batch_;
};

// Is each lane of the batch in the mask? (Counting bits costs a call where x86-64 has no popcnt.)
bool all_lanes(const FragmentMask& mask, const FragmentBatch& batch) {
    constexpr std::uint64_t Full = ~std::uint64_t{0};
    const unsigned whole = batch.lanes() / 64, rest = batch.lanes() % 64;
    for (unsigned i = 0; i < whole; ++i)
        if (mask.words[i] != Full) return false;
    return rest == 0 || mask.words[whole] == Full >> (64 - rest);
}

// Calls row(q) for four quads side by side, one(q) for others, of a batch whose lanes are all live.
// In other batches to look for rows takes longer than they save.
template <class Row, class One>
void for_rows(const FragmentBatch& batch, Row&& row, One&& one) {
    const unsigned quads = batch.quad_count;
    for (unsigned q = 0; q < quads;) {
        if (q + RowQuads <= quads && is_row(batch, q)) {
            row(q);
            q += RowQuads;
        } else {
            one(q++);
        }
    }
}

// Calls visit(q, its lanes) for each quad with a lane in the mask. Which these are no branch could
// foretell: they are found by their bits. The mask is copied, as those below are.
template <class Visit>
void for_live_quads(const FragmentMask& mask, unsigned quads, Visit&& visit) {
    constexpr std::uint64_t FirstLanes = 0x1111111111111111;
    constexpr unsigned WordQuads = 16;
    for (unsigned first = 0; first < quads; first += WordQuads) {
        const std::uint64_t word = mask.words[first / WordQuads];
        const std::uint64_t pairs = word | word >> 1;
        for (std::uint64_t left = (pairs | pairs >> 2) & FirstLanes; left != 0; left &= left - 1) {
            const auto bit = static_cast<unsigned>(std::countr_zero(left));
            visit(first + bit / 4, static_cast<unsigned>(word >> bit & 0xf));
        }
    }
}

// The masks are copied: a store of pixels might change them, for all that the compiler knows.
template <class Pixel>
void load_sized(const QuadSurface<Pixel, const std::byte>& surface,
                const FragmentBatch& batch,
                std::uint32_t* pixels) {
    const unsigned quads = batch.quad_count;
    if (all_lanes(batch.live, batch)) { // so that each quad is whole
        if constexpr (sizeof(Pixel) == 4) return load_rows(surface.rows(), batch, pixels);
        for_rows(
            batch,
            [&](unsigned q) { surface.load_row(q, pixels + 4 * q); },
            [&](unsigned q) { surface.load(q, pixels + 4 * q); });
        return;
    }
    if (surface.even()) { // Which quads are live is not asked: no branch could be foretold.
        for (unsigned q = 0; q < quads; ++q)
            surface.load(q, pixels + 4 * q);
        return;
    }
    for_live_quads(batch.live, quads, [&](unsigned q, unsigned lanes) {
        if (surface.is_whole(q))
            surface.load(q, pixels + 4 * q);
        else
            surface.load_pixels(q, lanes, pixels + 4 * q);
    });
}

template <class Pixel>
void store_sized(const QuadSurface<Pixel, std::byte>& surface,
                 const FragmentBatch& batch,
                 const FragmentMask& mask,
                 const std::uint32_t* pixels) {
    const unsigned quads = batch.quad_count;
    if (all_lanes(mask, batch)) {
        if constexpr (sizeof(Pixel) == 4) return store_rows(surface.rows(), batch, pixels);
        for_rows(
            batch,
            [&](unsigned q) { surface.store_row(q, pixels + 4 * q); },
            [&](unsigned q) { surface.store(q, pixels + 4 * q); });
        return;
    }
    if (surface.even()) { // As above: quads without a lane in the mask keep what they have.
        const FragmentMask lanes = mask;
        for (unsigned q = 0; q < quads; ++q)
            surface.store_masked(q, lanes.quad(q), pixels + 4 * q);
        return;
    }
    for_live_quads(mask, quads, [&](unsigned q, unsigned lanes) {
        if (surface.is_whole(q))
            surface.store_masked(q, lanes, pixels + 4 * q);
        else
            surface.store_pixels(q, lanes, pixels + 4 * q);
    });
}

} // namespace

void load_quads(const Surface& surface,
                std::span<const std::byte> memory,
                const FragmentBatch& batch,
                LaneWords& pixels) {
    switch (format_info(surface.format).block_bytes) {
    case 1:
        return load_sized<std::uint8_t>({surface, memory, batch}, batch, pixels.data());
    case 2:
        return load_sized<std::uint16_t>({surface, memory, batch}, batch, pixels.data());
    case 4:
        return load_sized<std::uint32_t>({surface, memory, batch}, batch, pixels.data());
    default:
        check(false, "load_quads: not a target's format");
    }
}

void store_quads(const Surface& surface,
                 std::span<std::byte> memory,
                 const FragmentBatch& batch,
                 const FragmentMask& mask,
                 const LaneWords& pixels) {
    switch (format_info(surface.format).block_bytes) {
    case 1:
        return store_sized<std::uint8_t>({surface, memory, batch}, batch, mask, pixels.data());
    case 2:
        return store_sized<std::uint16_t>({surface, memory, batch}, batch, mask, pixels.data());
    case 4:
        return store_sized<std::uint32_t>({surface, memory, batch}, batch, mask, pixels.data());
    default:
        check(false, "store_quads: not a target's format");
    }
}

} // namespace ffgpu
