// When a scene of a tile-based machine ends: by what the application did, and by nothing else.

#include "model/work/machine_order.h"
#include "tests/support/drawn_quad.h"

#include <algorithm>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr DeviceAddress TargetAt = 1 << 20, TextureAt = 1 << 24;
constexpr std::uint16_t Size = 64;
constexpr std::uint32_t TargetBytes = Size * Size * 4;

// A letter for each thing that the machine is to do; a scene tells how many draws it has.
class Log : public MachineSink {
public:
    void scene(PreparedScene&& scene) override {
        text += std::to_string(scene.draws.size()) + ' ';
        last = std::move(scene);
    }
    void transfer(PreparedTransfer&& transfer) override {
        text += transfer.kind == WorkKind::Clear ? "clear " : "copy ";
    }
    void host_transfer(const HostTransfer& transfer) override {
        text += transfer.is_write ? "write " : "read ";
    }
    void end_frame(std::uint32_t) override { text += "end "; }

    std::string text;
    PreparedScene last;
};

Surface target(DeviceAddress at) {
    return {at, Format::Rgba8, Size, Size, Size * 4};
}

struct Machine {
    Log log;
    MachineOrder order;
    Registers registers;

    explicit Machine(Architecture architecture)
        : order(
              [architecture] {
                  WorkConfig config;
                  config.raster.architecture = architecture;
                  return config;
              }(),
              log) {
        registers.targets.color[0] = target(TargetAt);
        registers.scissor.width = registers.scissor.height = Size;
        registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
        registers.images[0].address = TextureAt;
    }

    // A quad at (x, y); textured: one texel of it.
    void draw(std::uint16_t x = 0, std::uint16_t y = 0, bool textured = false) {
        auto command = std::make_shared<WholeCommand>();
        command->draw.state = std::make_shared<const Registers>(registers);
        command->quads.push_back(drawn_quad(x, y, 1));
        if (textured) {
            command->units = {0};
            command->add_access(0, TexelAccess{});
        }
        order.command(std::move(command));
    }
    void whole(WorkKind kind) {
        auto command = std::make_shared<WholeCommand>();
        command->draw.kind = kind;
        command->draw.state = std::make_shared<const Registers>(registers);
        command->draw.clear.color = true;
        command->draw.copy = {.source = target(TargetAt), .destination = target(1 << 25)};
        order.command(std::move(command));
    }
    void host(bool is_write, DeviceAddress at) {
        order.host_transfer({.is_write = is_write, .at = at, .bytes = 4});
    }
};

TEST_CASE("An immediate machine takes each draw for itself") {
    Machine machine(Architecture::Immediate);
    machine.draw();
    machine.draw();
    machine.order.end_frame(0);
    CHECK(machine.log.text == "1 1 end ");
}

// Takes quads in parts, if it is to, and keeps them all.
class Keeper : public MachineSink {
public:
    explicit Keeper(bool takes)
        : takes_(takes) {}

    bool takes_parts() const override { return takes_; }
    void scene(PreparedScene&& scene) override {
        text += "draw ";
        keep(scene);
        scenes.push_back(std::move(scene));
    }
    void part(PreparedPart&& part) override {
        text += "part ";
        PreparedScene& scene = *std::find_if(
            scenes.begin(), scenes.end(), [](const auto& each) { return each.quads_to_come > 0; });
        scene.quads_to_come -= part.quads.size();
        set_ends(part.ends, scene);
        keep(part);
    }
    void transfer(PreparedTransfer&&) override {}
    void host_transfer(const HostTransfer&) override { text += "write "; }
    void end_commands() override { text += "commands_end "; }
    void end_frame(std::uint32_t) override { text += "end "; }

    // Where each quad is, where it is in the walk, and what it reads and writes.
    using Quad = std::vector<std::uint64_t>;
    std::vector<Quad> quads;
    std::vector<PreparedScene> scenes;
    std::string text;

private:
    void keep(const PreparedQuads& made) {
        for (const PreparedQuad& quad : made.quads) {
            Quad& kept = quads.emplace_back(Quad{quad.x, quad.y, quad.new_tile, quad.empty_blocks});
            for (const auto lines :
                 {made.lines_of(quad), made.depth_lines(quad), made.color_lines(quad)})
                kept.insert(kept.end(), lines.begin(), lines.end());
        }
    }

    const bool takes_;
};

// A square of side 2 quads a side, as one piece, with a texel for each.
std::shared_ptr<const WholeCommand> square(const Registers& registers, std::uint16_t side) {
    auto command = std::make_shared<WholeCommand>();
    command->draw.state = std::make_shared<const Registers>(registers);
    command->units = {0};
    command->draw.geometry.vertices = {0, 1, 2};
    command->draw.geometry.primitives = {{.key = 0, .last_vertex = 2, .pieces = 1}};
    const auto pixels = static_cast<std::uint16_t>(2 * side);
    command->draw.geometry.pieces = {{0, 0, pixels, static_cast<std::uint16_t>(pixels + 8)}};
    for (std::uint16_t y = 0; y < pixels; y += 2) {
        for (std::uint16_t x = 0; x < pixels; x += 2) {
            command->quads.push_back(drawn_quad(x, y, 1));
            TexelAccess access{};
            access.x0 = access.x1 = static_cast<std::uint16_t>(x % 16);
            access.y0 = access.y1 = static_cast<std::uint16_t>(y % 16);
            command->add_access(0, access);
        }
    }
    return command;
}

// Three draws whose texture is written anew between them.
Keeper draw_squares(bool takes_parts, std::uint16_t side) {
    Keeper keeper(takes_parts);
    Registers registers;
    registers.targets.color[0] = {TargetAt, Format::Rgba8, 256, 256, 256 * 4};
    registers.scissor.width = registers.scissor.height = 256;
    registers.images[0].shape = {TextureKind::TwoD, Format::Rgba8, 16, 16, 1, 1, 0};
    registers.images[0].address = TextureAt;
    WorkConfig config;
    config.texel_cache.rewritten = RewrittenLevel::NewPlace;
    MachineOrder order(config, keeper);
    for (int i = 0; i < 3; ++i) {
        order.command(square(registers, side));
        order.host_transfer({.is_write = true, .at = TextureAt, .bytes = 4});
    }
    order.end_frame(0);
    return keeper;
}

TEST_CASE("Draws of many quads are told before these, which come in parts") {
    const Keeper whole = draw_squares(false, 64), parts = draw_squares(true, 64);
    CHECK(whole.text == "draw write draw write draw write end ");
    CHECK(parts.text == "draw write draw write draw write commands_end "
                        "part part part part part part end ");
    CHECK(whole.quads.size() == 3 * 64 * 64);
    CHECK(parts.quads == whole.quads);
    REQUIRE(parts.scenes.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(parts.scenes[i].quads.empty());
        CHECK(parts.scenes[i].draws[0].quad_count == 64 * 64);
        REQUIRE(parts.scenes[i].pieces.size() == 1);
        CHECK(parts.scenes[i].pieces[0].end == 64 * 64);
        CHECK(parts.scenes[i].pieces[0].empty_blocks == whole.scenes[i].pieces[0].empty_blocks);
        CHECK(parts.scenes[i].pieces[0].empty_blocks == 128 / 8); // the eight rows below
    }
    // Each draw's texels lie where they were when it was told.
    CHECK(parts.quads[0] != parts.quads[64 * 64]);
}

TEST_CASE("Draws of few quads are told with them") {
    CHECK(draw_squares(true, 16).text == "draw write draw write draw write end ");
    CHECK(draw_squares(true, 17).text == "draw write draw write draw write commands_end "
                                         "part part part end ");
}

TEST_CASE("A tile-based machine's scene goes on over uploads and reads of other memory") {
    Machine machine(Architecture::TileBased);
    machine.draw();
    machine.host(true, TextureAt);
    machine.host(false, TargetAt + TargetBytes); // The byte behind the target.
    machine.host(true, TargetAt - 4);
    machine.draw(0, 0, true);
    machine.order.end_frame(0);
    CHECK(machine.log.text == "write read write 2 end ");
}

TEST_CASE("A scene ends where the driver reads or writes its target's first or last byte") {
    const bool is_write = GENERATE(false, true);
    const std::string what = is_write ? "write " : "read ";
    Machine machine(Architecture::TileBased);
    machine.draw();
    machine.host(is_write, TargetAt + TargetBytes - 1);
    machine.draw();
    machine.host(is_write, TargetAt - 3);
    machine.draw();
    machine.order.end_frame(0);
    CHECK(machine.log.text == "1 " + what + "1 " + what + "1 end ");
}

TEST_CASE("A scene ends with its targets, a copy, and what reads it; clears are part of it") {
    Machine machine(Architecture::TileBased);
    machine.whole(WorkKind::Clear);
    machine.draw();
    machine.whole(WorkKind::Clear);
    machine.draw();
    machine.draw();
    machine.whole(WorkKind::Copy);
    machine.draw();
    machine.registers.targets.color[0].address = TextureAt;
    machine.draw();
    machine.draw();
    machine.draw(0, 0, true); // It reads what the two drew.
    machine.draw();
    machine.order.end_frame(0);
    CHECK(machine.log.text == "5 copy 1 2 2 end ");
}

TEST_CASE("A scene's quads come screen bin by screen bin, in each in the order of the draws") {
    Machine machine(Architecture::TileBased); // bins of 32 pixels
    machine.draw(40, 40);
    machine.draw(2, 2);
    machine.draw(40, 0);
    machine.draw(0, 0);
    machine.draw(34, 34);
    machine.order.end_frame(0);
    std::vector<std::uint32_t> draws;
    for (const PreparedQuad& quad : machine.log.last.quads)
        draws.push_back(quad.draw);
    CHECK(draws == std::vector<std::uint32_t>{1, 3, 2, 0, 4});
    CHECK(std::all_of(machine.log.last.quads.begin(),
                      machine.log.last.quads.end(),
                      [](const PreparedQuad& quad) { return quad.new_tile; }));
}

} // namespace
} // namespace ffgpu::work
