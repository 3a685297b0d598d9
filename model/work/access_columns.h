// The columns of a work file that tell what quads read.

#pragma once

#include "model/work/column_bytes.h"
#include "model/work/work_file_format.h"

#include <cstddef>
#include <cstdint>

namespace ffgpu::work {

// What a number of 32 bits, a step of 16, and an access take at most.
constexpr std::size_t MostOfNumber = 5, MostOfStep = 3, MostOfRare = 1 + 4 * MostOfStep;
constexpr std::size_t MostOfAccess = 1 + 2 * MostOfStep + MostOfRare;

// Where accesses are written: the ends of their columns.
struct AccessCursors {
    std::uint8_t *number, *shape, *x, *y, *rare;
};

inline std::uint8_t* put_step(std::uint8_t* to, std::uint16_t value, std::uint16_t expected) {
    return put_number(to, zigzag(static_cast<std::int16_t>(value - expected)));
}

inline std::uint8_t*
put_rare(std::uint8_t* to, const TexelAccess& access, std::uint16_t expected_layer) {
    const unsigned linear = access.linear;
    *to++ = access.level;
    to = put_step(to, access.x1, static_cast<std::uint16_t>(access.x0 + (linear & 1)));
    to = put_step(to, access.y1, static_cast<std::uint16_t>(access.y0 + (linear >> 1 & 1)));
    to = put_step(to, access.layer0, expected_layer);
    return put_step(to, access.layer1, static_cast<std::uint16_t>(access.layer0 + (linear >> 2)));
}

// The next access of a quad.
inline void
put_access(const TexelAccess& access, AccessForecast::Quad& forecast, AccessCursors& to) {
    const AccessForecast::Expected expected = forecast.next(access.lane);
    const unsigned linear = access.linear;
    const bool foreseen =
        access.level == expected.level && access.layer0 == expected.layer &&
        access.x1 == static_cast<std::uint16_t>(access.x0 + (linear & 1)) &&
        access.y1 == static_cast<std::uint16_t>(access.y0 + (linear >> 1 & 1)) &&
        access.layer1 == static_cast<std::uint16_t>(access.layer0 + (linear >> 2));
    *to.shape++ =
        static_cast<std::uint8_t>(access.lane | linear << 2 | (foreseen ? ShapeForeseen : 0));
    to.x = put_step(to.x, access.x0, expected.x);
    to.y = put_step(to.y, access.y0, expected.y);
    if (!foreseen) to.rare = put_rare(to.rare, access, expected.layer);
    forecast.take({access.x0, access.y0, access.level, access.layer0});
}

// Some quads of a command.
struct QuadRange {
    const WholeCommand& command;
    std::size_t first, count;
};

// Writes their accesses, and how many each quad has in each unit; returns the ends. There is room
// for the most that they may take.
AccessCursors put_accesses(const QuadRange& quads, AccessForecast& forecast, AccessCursors to);

} // namespace ffgpu::work
