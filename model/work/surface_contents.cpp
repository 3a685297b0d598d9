#include "model/work/surface_contents.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu::work {
namespace {

std::uint32_t sample_bytes(const PlacedLevel& place) {
    return place.layout.element_bytes / place.samples;
}

} // namespace

BlockShape line_shape(const PlacedLevel& place, Format format, std::uint32_t line_bytes) {
    const std::uint32_t pixels = line_bytes / place.layout.element_bytes;
    check(pixels > 0, "a line holds a pixel at least");
    const std::uint32_t row = place.layout.kind == Layout::Linear ? pixels : place.layout.block;
    const std::uint32_t width = std::min(row, pixels);
    return {format, width, pixels / width, place.samples};
}

std::vector<std::byte> SurfaceContents::laid_out(const PlacedLevel& place,
                                                 const SurfaceContent& content) const {
    const Surface& surface = content.surface;
    const std::size_t lines = (place.layer_bytes + line_bytes_ - 1) / line_bytes_;
    std::vector<std::byte> bytes(lines * line_bytes_);
    const std::size_t size = sample_bytes(place);
    const std::byte* from = content.bytes.data();
    for (unsigned sample = 0; sample < surface.samples; ++sample)
        for (std::uint32_t y = 0; y < surface.height; ++y)
            for (std::uint32_t x = 0; x < surface.width; ++x, from += size)
                std::memcpy(
                    &bytes[place.address(x, y, 0) - place.base + sample * size], from, size);
    return bytes;
}

const SurfaceContents::Held* SurfaceContents::find(std::uint64_t address) const {
    auto after = held_.upper_bound(address);
    if (after == held_.begin()) return nullptr;
    const Held& held = (--after)->second;
    return address - held.place.base < held.bytes.size() ? &held : nullptr;
}

void SurfaceContents::write(const PlacedLevel& place,
                            const PreparedQuad& quad,
                            const SampleWords& values,
                            std::uint64_t number) {
    Held* const held = find(place.base);
    if (!held) return;
    const std::size_t size = sample_bytes(place);
    std::size_t next = 0;
    for_each_sample(values.samples, [&](unsigned lane, unsigned sample) {
        const std::uint64_t at =
            place.address(quad.x + (lane & 1u), quad.y + (lane >> 1), 0) + sample * size;
        if (at / line_bytes_ == number)
            std::memcpy(&held->bytes[at - place.base], &values.words[next], size);
        ++next;
    });
}

void SurfaceContents::fill(const SurfaceFill& fill) {
    Held* const held = find(fill.place.base);
    if (!held) return;
    const std::size_t size = sample_bytes(fill.place);
    for (int y = fill.rectangle.y0; y < fill.rectangle.y1; ++y)
        for (int x = fill.rectangle.x0; x < fill.rectangle.x1; ++x) {
            const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
            const std::uint32_t bits = fill.value_at(column, row) & fill.mask;
            std::byte* at = &held->bytes[fill.place.address(column, row, 0) - fill.place.base];
            for (unsigned sample = 0; sample < fill.place.samples; ++sample, at += size) {
                std::uint32_t word = 0;
                std::memcpy(&word, at, size);
                word = (word & ~fill.mask) | bits;
                std::memcpy(at, &word, size);
            }
        }
}

std::span<const std::byte> SurfaceContents::line(std::uint64_t number) const {
    const std::uint64_t address = number * line_bytes_;
    const Held* const held = find(address);
    if (!held) return {};
    return std::span(held->bytes).subspan(address - held->place.base, line_bytes_);
}

BlockShape SurfaceContents::shape(std::uint64_t number) const {
    const Held* const held = find(number * line_bytes_);
    check(held != nullptr, "a line of no surface");
    return line_shape(held->place, held->format, line_bytes_);
}

std::uint32_t SurfaceContents::word(const PlacedLevel& place,
                                    std::uint32_t x,
                                    std::uint32_t y,
                                    unsigned sample) const {
    const Held* const held = find(place.base);
    check(held != nullptr, "no content of this surface");
    const std::size_t size = sample_bytes(place);
    std::uint32_t word = 0;
    std::memcpy(&word, &held->bytes[place.address(x, y, 0) - place.base + sample * size], size);
    return word;
}

} // namespace ffgpu::work
