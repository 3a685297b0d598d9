// Colours of a batch at a time: the blend by vectors, rows of quads to and from the target.

#include "model/fragment/color_target.h"
#include "model/fragment/quad_access.h"

namespace ffgpu {
namespace {

// Calls convert(word, lane) for each lane's word, in place.
template <class Convert>
void for_lanes(LaneWords& words, unsigned lanes, Convert&& convert) {
    for (unsigned i = 0; i < lanes; ++i)
        words.words[i] = convert(words.words[i], i);
}

// Pixels of the format to colours.
void unpack_colors(Format format, unsigned lanes, LaneWords& colors) {
    if (format == Format::Rgba8) return;
    visit_plain_color(format, [&](auto known) {
        for_lanes(colors, lanes, [&](std::uint32_t pixel, unsigned) {
            return unpack_pixel(known.value, pixel);
        });
    });
}

// Colours to pixels of the format.
void pack_colors(Format format, const FragmentBatch& batch, bool dither, LaneWords& colors) {
    if (format == Format::Rgba8) return;
    const bool dithers = dither && is_narrow(format);
    visit_plain_color(format, [&](auto known) {
        if (!dithers) {
            for_lanes(colors, batch.lanes(), [&](std::uint32_t color, unsigned) {
                return pack_pixel(known.value, color);
            });
            return;
        }
        for_lanes(colors, batch.lanes(), [&](std::uint32_t color, unsigned lane) {
            const std::uint32_t x = batch.x[lane / 4] + (lane & 1u);
            const std::uint32_t y = batch.y[lane / 4] + (lane >> 1 & 1u);
            return pack_pixel(known.value, color, Dithered{bayer_threshold(x, y)});
        });
    });
}

void load_colors(const Surface& surface,
                 std::span<const std::byte> memory,
                 const FragmentBatch& batch,
                 LaneWords& colors) {
    load_quads(surface, memory, batch, colors);
    unpack_colors(surface.format, batch.lanes(), colors);
}

void store_colors(const ColorStage& stage,
                  const Surface& surface,
                  const FragmentBatch& batch,
                  std::span<std::byte> memory,
                  LaneWords& colors) {
    pack_colors(surface.format, batch, stage.dither, colors);
    store_quads(surface, memory, batch, batch.live, colors);
}

std::uint32_t channel_bits(unsigned write_mask) {
    std::uint32_t bits = 0;
    for (unsigned channel = 0; channel < 4; ++channel)
        if ((write_mask >> channel & 1) != 0) bits |= 0xffu << 8 * channel;
    return bits;
}

bool writes_all_channels(const ColorTarget& target) {
    return target.write_mask == stored_channels(target.surface.format);
}

// From what the target holds to what it will hold, in rgba8; the write mask comes later.
void apply_operation(const ColorStage& stage,
                     Format format,
                     const FragmentBatch& batch,
                     LaneWords& colors) {
    if (stage.operation == ColorOperation::Blend) return stage.kernel(stage.state, batch, colors);
    LaneWords source;
    pack_color(batch, source);
    if (stage.operation == ColorOperation::Replace) {
        colors = source;
        return;
    }
    pack_colors(format, batch, stage.dither, source);
    unpack_colors(format, batch.lanes(), source);
    apply_logic_op(stage.state.logic_op, source, colors, batch.lanes());
}

} // namespace

void write_color(const ColorStage& stage,
                 const ColorTarget& target,
                 const FragmentBatch& batch,
                 std::span<std::byte> memory) {
    if (target.write_mask == 0) return;
    // Tables and 33 bits: no faster by vectors.
    if (target.srgb) return write_color_scalar(stage, target, batch, memory);
    const Surface& surface = target.surface;
    LaneWords colors;
    if (stage.operation == ColorOperation::Replace && writes_all_channels(target)) {
        pack_color(batch, colors);
        return store_colors(stage, surface, batch, memory, colors);
    }
    load_colors(surface, memory, batch, colors);
    if (writes_all_channels(target)) {
        apply_operation(stage, surface.format, batch, colors);
        return store_colors(stage, surface, batch, memory, colors);
    }
    const LaneWords stored = colors;
    const std::uint32_t written = channel_bits(target.write_mask);
    apply_operation(stage, surface.format, batch, colors);
    for (unsigned i = 0; i < batch.lanes(); ++i)
        colors.words[i] = (colors.words[i] & written) | (stored.words[i] & ~written);
    store_colors(stage, surface, batch, memory, colors);
}

} // namespace ffgpu
