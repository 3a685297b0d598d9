// AddressMap: gives textures and surfaces their places in the explored machine's address space, in
// the layouts of the configuration. Places are handed out in the order of first use and never
// reused. Texels that are written to a level which has a place change where they lie, or the level
// gets a new place: either way their next reads are misses, as they are on a real bus.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"
#include "model/work/config.h"
#include "model/work/level_lines.h"
#include "model/work/placed_level.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace ffgpu::work {

// Of device memory, half open.
struct ByteRange {
    std::uint64_t begin = 0, end = 0;

    bool overlaps(const ByteRange& other) const { return begin < other.end && other.begin < end; }
};

class AddressMap {
public:
    explicit AddressMap(const TexelCacheShape& textures)
        : texture_shape_(textures) {}

    // The levels of a texture; the reference holds until the next call.
    const std::vector<PlacedLevel>& texture(const TextureImage& image) {
        return placed(image).lines->levels;
    }
    // The same with the lines of the texel cache; who shares them keeps them as they are now.
    std::shared_ptr<const TextureLines> texture_lines(const TextureImage& image) {
        return placed(image).lines;
    }

    // A colour or depth target, in the layout of its cache; a pixel's samples lie together. It
    // never moves: the reference holds as long as the map.
    const PlacedLevel& surface(const Surface& surface, const CacheShape& cache);

    // These bytes of device memory were written. `rewritten`: of the levels that were read before.
    // Returns the lines of the texel cache that hold what changed in its place, each once, in
    // rising order.
    std::vector<std::uint64_t> memory_written(std::span<const ByteRange> ranges,
                                              RewrittenLevel rewritten);
    std::vector<std::uint64_t>
    memory_written(std::uint64_t at, std::uint64_t bytes, RewrittenLevel rewritten) {
        const ByteRange range{at, at + bytes};
        return memory_written(std::span(&range, 1), rewritten);
    }
    // As the configuration has it.
    std::vector<std::uint64_t> memory_written(std::span<const ByteRange> ranges) {
        return memory_written(ranges, texture_shape_.rewritten);
    }
    std::vector<std::uint64_t> memory_written(std::uint64_t at, std::uint64_t bytes) {
        return memory_written(at, bytes, texture_shape_.rewritten);
    }
    // The same of the pixels that a copy writes.
    std::vector<std::uint64_t> copied(const CopyRectangleCommand& copy, RewrittenLevel rewritten);
    std::vector<std::uint64_t> copied(const CopyRectangleCommand& copy) {
        return copied(copy, texture_shape_.rewritten);
    }

    // Whether a texture that was read lies there.
    bool holds_texels(const ByteRange& range) const;

private:
    struct Texture {
        TextureImage image;
        ByteRange bytes;
        std::shared_ptr<TextureLines> lines;

        // To change them: a copy, where somebody shares them.
        TextureLines& own_lines();
    };

    std::uint64_t place(std::uint64_t bytes);
    const Texture& placed(const TextureImage& image);
    PlacedLevel place_level(const TextureImage& image, std::uint32_t level);

    const TexelCacheShape texture_shape_;
    std::map<DeviceAddress, Texture> textures_;
    std::map<std::tuple<DeviceAddress, Format, std::uint32_t, std::uint32_t, std::uint32_t>,
             PlacedLevel>
        surfaces_;
    std::uint64_t next_ = std::uint64_t{1} << 32; // Above all device addresses.
};

} // namespace ffgpu::work
