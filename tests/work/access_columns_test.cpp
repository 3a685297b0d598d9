// put_accesses(), which looks at the lanes of a quad at once, against its accesses one by one.

#include "model/work/access_columns.h"

#include <array>
#include <iterator>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Quads of a filter that walks over a texture, with what breaks its steps now and then.
class RandomReads {
public:
    explicit RandomReads(unsigned seed)
        : random_(seed) {
        command.units = {1, 3};
    }

    // What it reads in each unit.
    void add_quad(unsigned odds) {
        command.quads.emplace_back();
        for (std::size_t unit = 0; unit < command.units.size(); ++unit)
            add_reads(unit, odds);
    }

    WholeCommand command;

private:
    void add_reads(std::size_t unit, unsigned odds) {
        const unsigned each = 1 + below(3) % 2; // accesses a lane
        x_ += below(9);
        y_ -= below(3);
        for (unsigned lane = 0; lane < 4; ++lane) {
            if (below(odds) == 0) continue; // is not covered
            const unsigned more = below(odds) == 0 ? 1 : 0;
            for (unsigned i = 0; i < each + more; ++i)
                command.add_access(unit, access(lane, i, odds));
        }
    }

    unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }

    TexelAccess access(unsigned lane, unsigned level, unsigned odds) {
        const auto narrow = [](unsigned value) { return static_cast<std::uint16_t>(value); };
        const unsigned linear = below(odds) == 0 ? below(8) : 3;
        TexelAccess made{.lane = narrow(lane),
                         .level = static_cast<std::uint8_t>(level),
                         .linear = static_cast<std::uint8_t>(linear),
                         .x0 = narrow((x_ + lane % 2) >> level),
                         .x1 = 0,
                         .y0 = narrow((y_ + lane / 2) >> level),
                         .y1 = 0,
                         .layer0 = 0,
                         .layer1 = 0};
        if (below(odds) == 0) made.x0 = narrow(below(1u << 16));
        if (below(odds) == 0) made.y0 = narrow(below(1u << 16));
        if (below(odds) == 0) made.layer0 = narrow(below(1u << 16));
        if (below(odds) == 0) made.level = static_cast<std::uint8_t>(below(12));
        made.x1 = below(odds) == 0 ? 0 : narrow(made.x0 + linear % 2);
        made.y1 = below(odds) == 0 ? 0 : narrow(made.y0 + linear / 2 % 2);
        made.layer1 = below(odds) == 0 ? 7 : narrow(made.layer0 + linear / 4);
        return made;
    }

    std::mt19937 random_;
    unsigned x_ = 0, y_ = 0;
};

// The columns, one behind the other, written by write(cursors), which returns their ends.
template <class Write>
std::vector<std::uint8_t> columns(std::size_t most, Write&& write) {
    std::array<std::vector<std::uint8_t>, 5> room;
    for (auto& column : room)
        column.resize(most);
    const AccessCursors end = write(AccessCursors{
        room[0].data(), room[1].data(), room[2].data(), room[3].data(), room[4].data()});
    std::vector<std::uint8_t> all;
    const std::array<const std::uint8_t*, 5> ends{end.number, end.shape, end.x, end.y, end.rare};
    for (std::size_t i = 0; i < room.size(); ++i)
        all.insert(all.end(), static_cast<const std::uint8_t*>(room[i].data()), ends[i]);
    return all;
}

TEST_CASE("The accesses of quads are told at once as they are one by one") {
    constexpr std::size_t Quads = 200, Most = 20 * MostOfAccess; // of a quad
    for (unsigned seed = 0; seed < 60; ++seed) {
        RandomReads reads(seed);
        for (std::size_t i = 0; i < Quads; ++i)
            reads.add_quad(seed % 3 == 0 ? 5 : 60);
        const WholeCommand& command = reads.command;
        AccessForecast forecast, forecast_one_by_one;
        const auto at_once = columns(Quads * Most, [&](AccessCursors to) {
            return put_accesses({command, 0, Quads}, forecast, to);
        });
        const auto one_by_one = columns(Quads * Most, [&](AccessCursors to) {
            for (std::size_t quad = 0; quad < Quads; ++quad)
                for (std::size_t unit = 0; unit < command.units.size(); ++unit) {
                    const QuadReads read = command.accesses_of(quad, unit);
                    to.number = put_number(
                        to.number,
                        static_cast<std::uint64_t>(std::distance(read.begin(), read.end())));
                    AccessForecast::Quad of_quad = forecast_one_by_one.quad(command.units[unit]);
                    for (const TexelAccess& access : read)
                        put_access(access, of_quad, to);
                }
            return to;
        });
        CHECK((at_once == one_by_one));
    }
}

} // namespace
} // namespace ffgpu::work
