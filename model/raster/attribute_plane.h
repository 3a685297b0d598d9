// AttributePlane: one attribute of a primitive in block floating point. All of it are integers but
// for one power of two, so that a value is the same by whatever path it is reached.
//
//     corner of a quad    (c + dx X + dy Y) rounded once from 14 guard bits: 32 bits with the sign
//     its other lanes     corner + offset, exactly
//     as binary32         to_float(lane) * scale, one rounding: that of the conversion
//
// Set-up chooses the exponent so that every lane of a quad that the primitive touches fits.

#pragma once

#include <array>
#include <cstdint>

namespace ffgpu {

struct AttributePlane {
    static constexpr int GuardBits = 14;
    static constexpr std::int64_t Half = std::int64_t{1} << (GuardBits - 1);

    std::int64_t c = 0, dx = 0, dy = 0; // with GuardBits; c at the centre of the reference pixel
    float scale = 1; // a power of two; of a / w it holds the exponent of 1 / w as well

    // Of a quad's corner pixel, relative to the reference pixel.
    std::int32_t corner(int x, int y) const {
        return static_cast<std::int32_t>((c + dx * x + dy * y + Half) >> GuardBits);
    }
    // What lanes 0 .. 3 of a quad have more than its corner.
    std::array<std::int32_t, 4> lane_offsets() const {
        const auto rounded = [](std::int64_t by) {
            return static_cast<std::int32_t>((by + Half) >> GuardBits);
        };
        return {0, rounded(dx), rounded(dy), rounded(dx + dy)};
    }
    // Of the pixel (x, y), relative to the reference pixel, which is the given lane of its quad.
    std::int32_t at(int x, int y, unsigned lane) const {
        const int right = static_cast<int>(lane & 1), up = static_cast<int>(lane >> 1 & 1);
        return corner(x - right, y - up) + lane_offsets()[lane % 4];
    }
};

} // namespace ffgpu
