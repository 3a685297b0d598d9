// SurfaceContents: what targets hold, byte for byte, laid out as in the explored machine's memory.
// It is told in the order in which that machine writes: contents as they come in, quads' values,
// clears. Without a clock.

#pragma once

#include "model/packets/quad_values.h"
#include "model/work/address_map.h"
#include "model/work/block_code.h"
#include "model/work/prepared_work.h"
#include "model/work/surface_fill.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu::work {

class SurfaceContents {
public:
    explicit SurfaceContents(std::uint32_t line_bytes)
        : line_bytes_(line_bytes) {}

    // From now on `place` holds this. Calls changed(line number) for each line that held something
    // else, or nothing.
    template <class Changed>
    void set(const PlacedLevel& place, const SurfaceContent& content, Changed&& changed);

    // The words of a quad's samples, as far as they lie in line `number`.
    void write(const PlacedLevel& place,
               const PreparedQuad& quad,
               const SampleWords& values,
               std::uint64_t number);
    void fill(const SurfaceFill& fill);

    // What a line of memory holds; empty where no target's content is known.
    std::span<const std::byte> line(std::uint64_t number) const;
    // Of a line whose content is known.
    BlockShape shape(std::uint64_t number) const;

    // The pixel's word.
    std::uint32_t
    word(const PlacedLevel& place, std::uint32_t x, std::uint32_t y, unsigned sample) const;

private:
    struct Held {
        PlacedLevel place;
        Format format = Format::None;
        std::vector<std::byte> bytes; // whole lines
    };

    const Held* find(std::uint64_t address) const;
    Held* find(std::uint64_t address) {
        return const_cast<Held*>(std::as_const(*this).find(address));
    }
    std::vector<std::byte> laid_out(const PlacedLevel& place, const SurfaceContent& content) const;

    std::uint32_t line_bytes_;
    std::map<std::uint64_t, Held> held_; // by base
};

// The pixels of a line in rows, so that neighbours are near: what a block code works on.
BlockShape line_shape(const PlacedLevel& place, Format format, std::uint32_t line_bytes);

template <class Changed>
void SurfaceContents::set(const PlacedLevel& place,
                          const SurfaceContent& content,
                          Changed&& changed) {
    std::vector<std::byte> bytes = laid_out(place, content);
    Held& held = held_[place.base];
    const bool is_new = held.bytes.size() != bytes.size();
    for (std::size_t at = 0; at < bytes.size(); at += line_bytes_)
        if (is_new || std::memcmp(&held.bytes[at], &bytes[at], line_bytes_) != 0)
            changed((place.base + at) / line_bytes_);
    held = {place, content.surface.format, std::move(bytes)};
}

} // namespace ffgpu::work
