// ElementChunks: how the elements of a draw are cut. Each chunk is assembled by itself; what
// strips, fans and loops carry over is an element of both.

#pragma once

#include "model/geometry/primitive_assembler.h"

#include <algorithm>
#include <cstdint>

namespace ffgpu {

class ElementChunks {
public:
    // Elements `begin` to `end` of the draw, without the hub. The last `fresh` are in no chunk
    // before; the hub is one of the first chunk's.
    struct Chunk {
        std::uint32_t begin, end, fresh;
    };

    // elements: of the draw, at least 1. size: of a chunk, beyond the rule's overlap.
    ElementChunks(ChunkRule rule, std::uint32_t elements, std::uint32_t size)
        : hub_(rule.hub)
        , elements_(elements)
        , size_(size)
        , step_(size - rule.overlap) {}

    std::uint32_t count() const {
        const std::uint32_t behind_hub = elements_ - hub_;
        return behind_hub <= size_ ? 1 : 1 + (behind_hub - size_ + step_ - 1) / step_;
    }

    Chunk operator[](std::uint32_t i) const {
        const std::uint32_t begin = hub_ + i * step_;
        const std::uint32_t end = begin + std::min(size_, elements_ - begin);
        return {begin, end, i == 0 ? end : end - (begin - step_ + size_)};
    }

private:
    std::uint32_t hub_, elements_, size_, step_;
};

} // namespace ffgpu
