#include "model/gpu/draw_context.h"

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace ffgpu {
namespace {

// By their alpha. Of several samples all is drawn.
bool colors_decide(const DrawState& state) {
    return state.regs().fragment.alpha_test || state.samples > 1;
}

std::shared_ptr<const PixelContext> compile_pixel_context(const DrawState& state,
                                                          std::span<std::byte> memory,
                                                          const FragmentStages& stages,
                                                          bool colors) {
    const Registers& r = state.regs();
    auto pixels = std::make_shared<PixelContext>();
    pixels->layout = state.layout;
    pixels->units = state.units;
    pixels->needs_depth = state.needs_depth;
    pixels->antialias = state.antialias;
    pixels->multisample = state.multisample;
    pixels->count_samples = r.fragment.count_samples;
    pixels->stipple = stipple_patterns(r.polygon_stipple, r.primitive);
    pixels->draws_colors = colors || colors_decide(state);
    pixels->pipe = compile_fragment_pipe(state, memory, stages);
    pixels->pipe.stores_colors = pixels->draws_colors;
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (pixels->samples(unit))
            pixels->textures[unit] = compile_texture_unit(r.images[unit], r.samplers[unit], memory);
    return pixels;
}

// The registers behind geometry, as bytes. Where those between members differ though no value does,
// a context is compiled in vain, no more.
std::span<const std::byte> pixel_registers(const Registers& registers) {
    static_assert(std::is_trivially_copyable_v<Registers>);
    return std::as_bytes(std::span(&registers, 1)).subspan(offsetof(Registers, primitive));
}

// Most registers that differ have another one. What is left over at the end does not count.
std::uint64_t fingerprint(std::span<const std::byte> bytes) {
    constexpr std::uint64_t Factor = 0x9e3779b97f4a7c15;
    std::array<std::uint64_t, 8> sums{}; // side by side: a product waits for the one before
    for (; bytes.size() >= sizeof sums; bytes = bytes.subspan(sizeof sums)) {
        std::array<std::uint64_t, 8> words;
        std::memcpy(words.data(), bytes.data(), sizeof words);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] = (sums[i] ^ words[i]) * Factor;
    }
    std::uint64_t all = 0;
    for (const std::uint64_t sum : sums)
        all = (all ^ sum ^ sum >> 32) * Factor;
    return all;
}

} // namespace

std::shared_ptr<const PixelContext> PixelContexts::of(const DrawState& state) {
    const std::span<const std::byte> bytes = pixel_registers(state.regs());
    const std::uint64_t print = fingerprint(bytes);
    for (const Kept& kept : kept_) {
        if (kept.fingerprint != print || kept.pixels->layout != state.layout) continue;
        const auto of_then = pixel_registers(*kept.pixels->pipe.registers);
        if (std::memcmp(of_then.data(), bytes.data(), bytes.size()) == 0) return kept.pixels;
    }
    auto pixels = compile_pixel_context(state, memory_, stages_, colors_);
    if (kept_.size() < Most) kept_.emplace_back();
    kept_[next_] = {print, pixels};
    next_ = (next_ + 1) % Most;
    return pixels;
}

std::shared_ptr<const DrawContext> compile_draw_context(std::shared_ptr<const Registers> registers,
                                                        std::uint32_t number,
                                                        PixelContexts& pixels,
                                                        const DrawContext* earlier) {
    auto context = std::make_shared<DrawContext>();
    context->state = compile_draw_state(std::move(registers), number);
    context->setup = compile_setup(context->state);
    // Which coordinates are carried depends on the vertices' format, matrices and generation.
    context->pixels = earlier && earlier->pixels->layout == context->state.layout
                          ? earlier->pixels
                          : pixels.of(context->state);
    return context;
}

} // namespace ffgpu
