// Accesses that are kept quad by quad, against lists of them.

#include "model/packets/texel_accesses.h"

#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

constexpr std::uint16_t Border = TexelAccess::BorderTexel;

class RandomQuads {
public:
    explicit RandomQuads(unsigned seed)
        : random_(seed) {}

    // What a filter reads, with something unusual now and then.
    std::vector<TexelAccess> quad(unsigned odds) {
        std::vector<TexelAccess> accesses;
        const unsigned levels = 1 + below(2), linear = below(4);
        const std::uint16_t layer = narrow(below(6)), level = narrow(below(10));
        for (unsigned lane = 0; lane < 4; ++lane) {
            if (below(8) == 0) continue;
            for (unsigned i = 0; i < levels; ++i) {
                TexelAccess access{.lane = narrow(lane),
                                   .level = static_cast<std::uint8_t>(level + i),
                                   .linear = static_cast<std::uint8_t>(linear),
                                   .x0 = narrow(below(300)),
                                   .x1 = 0,
                                   .y0 = narrow(below(300)),
                                   .y1 = 0,
                                   .layer0 = layer,
                                   .layer1 = layer};
                access.x1 = narrow(access.x0 + linear % 2);
                access.y1 = narrow(access.y0 + linear / 2);
                if (below(odds) == 0) disturb(access);
                accesses.push_back(access);
            }
        }
        if (below(odds) == 0 && !accesses.empty()) accesses.pop_back();
        return accesses;
    }

private:
    unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }
    static std::uint16_t narrow(unsigned value) { return static_cast<std::uint16_t>(value); }

    void disturb(TexelAccess& access) {
        const auto any = narrow(below(2) == 0 ? 0xffff : below(1u << 16));
        switch (below(8)) {
        case 0:
            access.level = static_cast<std::uint8_t>(below(256));
            break;
        case 1:
            access.linear = static_cast<std::uint8_t>(below(8));
            break;
        default:
            std::uint16_t* const numbers[]{
                &access.x0, &access.x1, &access.y0, &access.y1, &access.layer0, &access.layer1};
            *numbers[below(6)] = any;
        }
    }

    std::mt19937 random_;
};

TEST_CASE("Accesses of any kind come out as they went in, quad by quad") {
    for (const unsigned odds : {2u, 10u, 100u}) {
        RandomQuads random(odds);
        TexelAccesses list, copy;
        std::vector<std::vector<TexelAccess>> expected;
        std::size_t count = 0;
        for (unsigned i = 0; i < 2000; ++i) {
            expected.push_back(random.quad(odds));
            list.add(expected.back());
            count += expected.back().size();
        }
        for (std::size_t i = 0; i < expected.size(); ++i) {
            REQUIRE((list.of(i).all() == expected[i]));
            REQUIRE(list.of(i).size() == expected[i].size());
            copy.add(list.of(i));
        }
        CHECK(list.quads() == expected.size());
        CHECK(list.count() == count);
        CHECK(list.words() >= count);
        CHECK((copy == list));
        copy.add(std::vector{TexelAccess{}});
        CHECK_FALSE((copy == list));
    }
}

TEST_CASE("Quads behind the last one have no accesses") {
    TexelAccesses list;
    CHECK(list.empty());
    CHECK(list.of(0).all().empty());
    list.add(std::vector<TexelAccess>{});
    CHECK(list.empty());
    CHECK(list.quads() == 1);
    CHECK(list.of(5).size() == 0);
}

TEST_CASE("Neighbours of one level take a word each, what meets the border does not") {
    const TexelAccess access{.lane = 6,
                             .level = 3,
                             .linear = 3,
                             .x0 = 7,
                             .x1 = 8,
                             .y0 = 1,
                             .y1 = 2,
                             .layer0 = 5,
                             .layer1 = 5};
    TexelAccesses list;
    list.add(std::vector{access});
    CHECK(list.words() == 1);
    CHECK(list.of(0).is_regular());
    CHECK(list.of(0).common().lanes == 1u << 2);
    CHECK(list.of(0).common().level == 3);
    CHECK(list.of(0).common().layer == 5);
    CHECK(list.of(0).places()[0] == (1u << 16 | 7u));
    CHECK(list.of(0).all()[0].lane == 2); // of the quad

    TexelAccess at_border = access;
    at_border.linear = 0;
    at_border.x0 = at_border.x1 = Border;
    at_border.y1 = at_border.y0;
    list.add(std::vector{at_border});
    CHECK_FALSE(list.of(1).is_regular());
}

} // namespace
} // namespace ffgpu
