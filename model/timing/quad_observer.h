// QuadObserver: is told what the machine in time does for single quads. It never changes a cycle.

#pragma once

#include "model/timing/tokens.h"

#include <compare>
#include <cstdint>

namespace ffgpu::timing {

// A quad, or a fragment of one where the machine's granularity is a fragment: of equal names.
struct QuadName {
    std::uint32_t draw = 0; // PrimitiveKey::draw
    std::uint32_t primitive = 0;
    std::uint32_t piece = 0;
    std::uint16_t x = 0, y = 0; // window pixel of lane 0

    // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14.
    auto operator<=>(const QuadName&) const = default;
};

inline QuadName name_of(const QuadToken& token) {
    const PreparedQuad& quad = token.quad();
    return {token.draw().number, quad.primitive, quad.piece, quad.x, quad.y};
}

// A look-up in a cache that the quad sees.
struct CacheLine {
    std::uint64_t number = 0; // of texels as work/texel_line.h has it, else address / line bytes
    bool missed = false;
    std::uint64_t cycle = 0; // since the machine's start
};

class QuadObserver {
public:
    virtual ~QuadObserver() = default;
    virtual void texel_line(const QuadName&, const CacheLine&) {}
    virtual void depth_line(const QuadName&, const CacheLine&) {}
    virtual void color_line(const QuadName&, const CacheLine&) {}
    // Its last fragments were written.
    virtual void retired(const QuadName&, std::uint64_t /*cycle*/) {}
};

} // namespace ffgpu::timing
