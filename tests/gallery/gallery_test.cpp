// Every technique against its oracle, and every oracle against a program that does one thing wrong.

#include "tests/gallery/offscreen/draw.h"

#include <iostream>

#include <catch2/catch.hpp>

namespace ffgpu::gallery {
namespace {

TEST_CASE("each program has the oracle of its row") {
    REQUIRE(programs().size() == claims().size());
    for (std::size_t i = 0; i < programs().size(); ++i)
        CHECK(programs()[i].row == claims()[i].row);
}

TEST_CASE("each technique draws what its formula says") {
    for (std::size_t i = 0; i < programs().size(); ++i) {
        const Claim& claim = claims()[i];
        const Difference found = difference(draw_offscreen(programs()[i], false), claim);
        const Difference broken = difference(draw_offscreen(programs()[i], true), claim);
        std::cout << claim.row << ' ' << programs()[i].name << ": worst " << found.worst << " of "
                  << claim.worst_allowed << ", rms " << found.rms << " of " << claim.rms_allowed
                  << "; broken: worst " << broken.worst << ", rms " << broken.rms << '\n';
        INFO(claim.row << ' ' << programs()[i].name << " at " << found.worst_x << ','
                       << found.worst_y);
        CHECK(found.worst <= claim.worst_allowed);
        CHECK(found.rms <= claim.rms_allowed);
        INFO("The oracle does not notice: " << claim.mutation);
        CHECK_FALSE(holds(broken, claim));
    }
}

} // namespace
} // namespace ffgpu::gallery
