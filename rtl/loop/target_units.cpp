// What reads, changes and writes a target. The target's memory is the host's.

#include "Vblend.h"
#include "Vstencil_depth.h"
#include "rtl/loop/loop_stages.h"
#include "rtl/loop/quads.h"
#include "rtl/loop/unit_driver.h"

#include <cstring>

namespace ffgpu::rtl {
namespace {

struct StencilDepthUnit : OneToOne<TargetQuad> {
    static constexpr const char* Name = "stencil_depth";
    using Dut = Vstencil_depth;
    using State = StencilDepthWords;
    using Input = TargetQuad;
    using Output = WrittenQuad;
};

struct BlendUnit : OneToOne<TargetQuad> {
    static constexpr const char* Name = "blend";
    using Dut = Vblend;
    using State = BlendWords;
    using Input = TargetQuad;
    using Output = WrittenQuad;
};

class TargetMemory {
public:
    TargetMemory(const Surface& surface, const FragmentBatch& batch, std::span<std::byte> memory)
        : surface_(surface)
        , batch_(batch)
        , memory_(memory)
        , bytes_(format_info(surface.format).block_bytes) {}

    std::vector<TargetQuad> read() const {
        std::vector<TargetQuad> quads;
        for (unsigned q = 0; q < batch_.quad_count; ++q) {
            quads.push_back({.quad = quad_of(batch_, q, batch_.color)});
            for (unsigned i = 0; i < Lanes; ++i)
                quads.back().pixels[i] = pixel(Lanes * q + i);
        }
        return quads;
    }

    // The memory has what the model made of the pixels that were read, and gets the unit's.
    void write(const char* unit,
               std::span<const TargetQuad> before,
               std::span<const WrittenQuad> after) const {
        for (unsigned lane = 0; lane < batch_.lanes(); ++lane) {
            if (!is_there(lane)) continue;
            const WrittenQuad& written = after[lane / Lanes];
            std::uint32_t word = before[lane / Lanes].pixels[lane % Lanes];
            for (unsigned byte = 0; byte < bytes_; ++byte) {
                const std::uint32_t mask = 0xffu << 8 * byte;
                if ((written.enables[lane % Lanes] >> byte & 1) != 0)
                    word = (word & ~mask) | (written.pixels[lane % Lanes] & mask);
            }
            compare_lane(at_lane(unit, batch_, lane), "pixel", pixel(lane), word);
            std::memcpy(at(lane), &word, bytes_);
        }
    }

private:
    bool is_there(unsigned lane) const { return bytes_ != 0 && batch_.live.test(lane); }
    std::byte* at(unsigned lane) const {
        const LanePosition place = lane_position(batch_, lane);
        return memory_.data() + surface_.address + std::size_t{place.y} * surface_.stride +
               std::size_t{place.x} * bytes_;
    }
    std::uint32_t pixel(unsigned lane) const {
        std::uint32_t word = 0;
        if (is_there(lane)) std::memcpy(&word, at(lane), bytes_);
        return word;
    }

    const Surface& surface_;
    const FragmentBatch& batch_;
    std::span<std::byte> memory_;
    unsigned bytes_;
};

} // namespace

StencilDepthFates test_depth_target(const StencilDepthState& state,
                                    const Surface& target,
                                    const FragmentBatch& batch,
                                    std::span<std::byte> memory) {
    const TargetMemory pixels(target, batch, memory);
    const std::vector<TargetQuad> before = pixels.read();
    const StencilDepthFates expected =
        FastFragmentStages.test_depth_target(state, target, batch, memory);
    const StencilDepthWords words{
        {.enable = state.stencil, .front = state.front, .back = state.back},
        state.depth,
        state.format};
    const auto written = unit<StencilDepthUnit>().run(words, before, bank_of(batch));
    pixels.write(StencilDepthUnit::Name, before, written);
    loop_log().count(StencilDepthUnit::Name, "", batch.live.count());
    // Who died by which of the tests is counted, and nothing else: the unit does not say it.
    return {expected.after_stencil,
            take_live(StencilDepthUnit::Name, written, batch, expected.after_depth)};
}

void write_color(const ColorStage& stage,
                 const ColorTarget& target,
                 const FragmentBatch& batch,
                 std::span<std::byte> memory) {
    if (target.surface.format == Format::None) return;
    const TargetMemory pixels(target.surface, batch, memory);
    const std::vector<TargetQuad> before = pixels.read();
    FastFragmentStages.write_color(stage, target, batch, memory);
    if (target.srgb) return loop_log().count(BlendUnit::Name, "sRGB targets", batch.live.count());
    BlendWords words{stage.state, {.dither = stage.dither}, target.surface.format};
    words.blend.write_mask = target.write_mask;
    pixels.write(BlendUnit::Name, before, unit<BlendUnit>().run(words, before, bank_of(batch)));
    loop_log().count(BlendUnit::Name, "", batch.live.count());
}

} // namespace ffgpu::rtl
