// Texels that are written to a level that has been read: which lines of the texel cache change, by
// hand from the coordinates; and when a machine is told.

#include "model/device/layout/texture_layout.h"
#include "model/work/address_map.h"
#include "model/work/first_level.h"
#include "model/work/machine_order.h"
#include "tests/support/drawn_quad.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

using Lines = std::vector<std::uint64_t>;

constexpr DeviceAddress TextureAt = 1 << 24;

TextureImage image_of(Format format, std::uint32_t size, std::uint32_t levels) {
    TextureImage image;
    image.shape = {TextureKind::TwoD, format, size, size, 1, levels, 0};
    image.address = TextureAt;
    return image;
}

TexelCacheShape cache_of(Layout layout, std::uint32_t line_bytes) {
    TexelCacheShape cache;
    cache.layout = layout;
    cache.line_bytes = line_bytes;
    return cache;
}

// Texel (x, y) of a level of Rgba8 texels `size` wide, in device memory.
DeviceAddress texel_at(std::uint64_t level, std::uint32_t size, std::uint32_t x, std::uint32_t y) {
    return static_cast<DeviceAddress>(TextureAt + level + (y * size + x) * 4);
}

Lines from(std::uint64_t base, Lines lines) {
    for (std::uint64_t& line : lines)
        line += base;
    return lines;
}

TEST_CASE("Rewritten texels change the lines that hold them", "[rewritten]") {
    const TextureImage image = image_of(Format::Rgba8, 16, 5);
    SECTION("of rows") { // A row of 16 texels is a line of 64 bytes.
        AddressMap addresses(cache_of(Layout::Linear, 64));
        const std::uint64_t base = addresses.texture(image)[0].base / 64;
        CHECK(addresses.memory_written(texel_at(0, 16, 15, 3), 4) == from(base, {3}));
        CHECK(addresses.memory_written(texel_at(0, 16, 15, 3), 8) == from(base, {3, 4}));
        CHECK(addresses.memory_written(texel_at(0, 16, 15, 3), 4 + 64 + 1) ==
              from(base, {3, 4, 5}));
        CHECK(addresses.memory_written(texel_at(0, 16, 0, 0), 16 * 64).size() == 16);
        CHECK(addresses.memory_written(TextureAt - 4, 4).empty());
        CHECK(addresses.memory_written(TextureAt - 4, 5) == from(base, {0}));
    }
    SECTION("of blocks") { // Of 4x4 texels: four in a row of blocks.
        AddressMap addresses(cache_of(Layout::Blocked, 64));
        const std::uint64_t base = addresses.texture(image)[0].base / 64;
        CHECK(addresses.memory_written(texel_at(0, 16, 5, 10), 4) == from(base, {4 * 2 + 1}));
        CHECK(addresses.memory_written(texel_at(0, 16, 2, 7), 3 * 4) == from(base, {4, 5}));
        CHECK(addresses.memory_written(texel_at(0, 16, 0, 4), 64) == from(base, {4, 5, 6, 7}));
    }
    SECTION("of a copied rectangle") { // Of blocks 1 to 2 across and 2 to 3 up.
        AddressMap addresses(cache_of(Layout::Blocked, 64));
        const std::uint64_t base = addresses.texture(image)[0].base / 64;
        CopyRectangleCommand copy;
        copy.destination = {TextureAt, Format::Rgba8, 16, 16, 16 * 4};
        copy.destination_x = 6;
        copy.destination_y = 9;
        copy.width = 3;
        copy.height = 5;
        CHECK(addresses.copied(copy) == from(base, {9, 10, 13, 14}));
        const std::vector<PlacedLevel> before = addresses.texture(image);
        CHECK(addresses.copied(copy, RewrittenLevel::NewPlace).empty());
        CHECK(addresses.texture(image)[0].base != before[0].base);
    }
    SECTION("of the level that is written, and of no other") {
        AddressMap addresses(cache_of(Layout::Linear, 64));
        const std::vector<PlacedLevel> levels = addresses.texture(image);
        const std::uint64_t second = level_layout(image.shape, 1).offset;
        CHECK(addresses.memory_written(texel_at(second, 8, 0, 2), 4) ==
              from(levels[1].base / 64, {1})); // Two rows of 8 texels are a line.
    }
    SECTION("of a texture that has no place") {
        AddressMap addresses(cache_of(Layout::Linear, 64));
        CHECK(addresses.memory_written(TextureAt, 4).empty());
    }
    SECTION("of compressed blocks, as they lie and expanded") {
        const TextureImage dxt1 = image_of(Format::Dxt1Rgb, 16, 1); // 4x4 blocks of 8 bytes
        AddressMap blocks(cache_of(Layout::Linear, 16));
        const std::uint64_t base = blocks.texture(dxt1)[0].base / 16;
        CHECK(blocks.memory_written(TextureAt + 5 * 8, 8) == from(base, {2}));
        TexelCacheShape cache = cache_of(Layout::Linear, 16);
        cache.contents = TexelContents::Texels; // 64 bytes a block: four lines
        AddressMap texels(cache);
        const PlacedLevel level = texels.texture(dxt1)[0];
        Lines expected;
        for (std::uint32_t y = 4; y < 8; ++y)
            expected.push_back(level.line(4, y, 0, 16));
        CHECK(texels.memory_written(TextureAt + 5 * 8, 8) == expected);
    }
}

TEST_CASE("A rewritten level stays where it is, or moves as the configuration has it",
          "[rewritten]") {
    const TextureImage image = image_of(Format::Rgba8, 16, 5);
    TexelCacheShape cache = cache_of(Layout::Linear, 64);
    for (const RewrittenLevel rewritten : {RewrittenLevel::InPlace, RewrittenLevel::NewPlace}) {
        const bool stays = rewritten == RewrittenLevel::InPlace;
        cache.rewritten = rewritten;
        AddressMap addresses(cache);
        const std::vector<PlacedLevel> before = addresses.texture(image);
        CHECK(addresses.memory_written(texel_at(0, 16, 1, 1), 4).empty() == !stays);
        const std::vector<PlacedLevel> after = addresses.texture(image);
        CHECK((after[0].base == before[0].base) == stays);
        for (std::size_t level = 1; level < before.size(); ++level)
            CHECK(after[level].base == before[level].base);
    }
}

// The lines that it looks up.
class Misses final : public LookupSink {
public:
    void lookups(LookupClient,
                 const LookupPlace&,
                 std::span<const LineLookup> looked_up,
                 std::uint32_t) override {
        for (const LineLookup& lookup : looked_up)
            lines.push_back(lookup.line);
    }
    void flush(LookupClient) override {}
    void overwritten(LookupClient, std::span<const OverwrittenLine> forgotten) override {
        for (const OverwrittenLine& line : forgotten)
            passed_on.push_back(line.line);
    }
    void end_frame(std::uint32_t) override {}

    Lines lines, passed_on;
};

TEST_CASE("A first level misses what was rewritten, and tells the levels behind it",
          "[rewritten]") {
    Misses misses;
    FirstLevel cache(1, 8, 64, misses);
    const std::vector<LineLookup> wanted{{1}, {2}, {3}};
    cache.lookups(LookupClient::Texel, {}, wanted, 3);
    cache.lookups(LookupClient::Texel, {}, wanted, 3);
    REQUIRE(misses.lines == Lines{1, 2, 3});
    tell_rewritten(Lines{2, 7}, cache);
    CHECK(misses.passed_on == Lines{2, 7});
    cache.lookups(LookupClient::Texel, {}, wanted, 3);
    CHECK(misses.lines == Lines{1, 2, 3, 2});
}

// --- When a machine is told ----------------------------------------------------------------------

// A letter for each thing that the machine is to do, and the lines.
class Log : public MachineSink {
public:
    void scene(PreparedScene&& scene) override {
        text += std::to_string(scene.draws.size()) + ' ';
        lines = scene.texel_lines;
    }
    void transfer(PreparedTransfer&&) override { text += "transfer "; }
    void host_transfer(const HostTransfer&) override { text += "host "; }
    void end_frame(std::uint32_t) override { text += "end "; }
    void texels_rewritten(Lines&& told) override {
        text += "rewritten ";
        rewritten = std::move(told);
    }

    std::string text;
    Lines lines, rewritten;
};

struct Machine {
    Log log;
    MachineOrder order;
    Registers registers;
    std::uint8_t lanes_written = 1;

    explicit Machine(Architecture architecture)
        : order(
              [architecture] {
                  WorkConfig config;
                  config.raster.architecture = architecture;
                  return config;
              }(),
              log) {
        registers.targets.color[0] = {1 << 20, Format::Rgba8, 64, 64, 64 * 4};
        registers.scissor.width = registers.scissor.height = 64;
        registers.images[0] = image_of(Format::Rgba8, 64, 1);
    }

    void clear() {
        auto command = std::make_shared<WholeCommand>();
        command->draw.kind = WorkKind::Clear;
        command->draw.clear.color = true;
        command->draw.state = std::make_shared<const Registers>(registers);
        order.command(std::move(command));
    }

    // A quad at (at, at) of which one fragment reads texel (x, y).
    void draw(std::uint16_t x, std::uint16_t y, std::uint16_t at = 0) {
        auto command = std::make_shared<WholeCommand>();
        command->draw.state = std::make_shared<const Registers>(registers);
        command->quads.push_back(drawn_quad(at, at, 1));
        command->quads.back().after_depth = lanes_written;
        command->units = {0};
        TexelAccess access{};
        access.x0 = x;
        access.y0 = y;
        command->add_access(0, access);
        order.command(std::move(command));
    }
    void write(std::uint32_t x, std::uint32_t y) {
        order.host_transfer({.is_write = true, .at = texel_at(0, 64, x, y), .bytes = 4});
    }
};

TEST_CASE("A machine is told of a rewritten line before the draw that reads it", "[rewritten]") {
    Machine machine(Architecture::Immediate);
    machine.draw(9, 9);
    const Lines read = machine.log.lines;
    REQUIRE(read.size() == 1);
    machine.write(9, 9);
    CHECK(machine.log.rewritten == read);
    machine.draw(9, 9);
    CHECK(machine.log.lines == read);
    CHECK(machine.log.text == "1 rewritten host 1 ");
}

TEST_CASE("A scene that is still gathered keeps the texels that it reads", "[rewritten]") {
    Machine machine(Architecture::TileBased);
    machine.draw(9, 9);
    machine.write(9, 9);
    machine.draw(9, 9);
    machine.order.end_frame(0);
    CHECK(machine.log.text == "host 2 end ");
    REQUIRE(machine.log.lines.size() == 2);
    CHECK(machine.log.lines[0] != machine.log.lines[1]);
    machine.write(9, 9); // Between scenes nobody reads them any more.
    CHECK(machine.log.text == "host 2 end rewritten host ");
    CHECK(machine.log.rewritten == Lines{machine.log.lines[1]});
}

// What the machine is told when a texture of 64 x 64 texels is read, written as a target, and read
// again; 16 texels lie in a line.
Log read_again(Architecture architecture, const std::function<void(Machine&)>& write) {
    Machine machine(architecture);
    machine.draw(9, 9);
    machine.order.end_frame(0);
    machine.log.text.clear();
    const Registers before = machine.registers;
    machine.registers.targets.color[0].address = TextureAt;
    machine.registers.images[0].shape.kind = TextureKind::None;
    write(machine);
    machine.registers = before;
    machine.lanes_written = 1;
    machine.draw(9, 9);
    machine.draw(9, 9); // It has been told of.
    machine.order.end_frame(1);
    return machine.log;
}

const Architecture Architectures[] = {Architecture::Immediate, Architecture::TileBased};

TEST_CASE("What was drawn into a texture is new to who reads it", "[rewritten]") {
    for (const Architecture architecture : Architectures) {
        const bool immediate = architecture == Architecture::Immediate;
        const Log log = read_again(architecture, [](Machine& machine) { machine.draw(0, 0, 8); });
        CHECK(log.text == (immediate ? "1 rewritten 1 1 end " : "1 rewritten 2 end "));
        CHECK(log.rewritten == Lines{log.lines[0]});
        const Log all = read_again(architecture, [](Machine& machine) { machine.clear(); });
        CHECK(all.rewritten.size() == 64 * 64 * 4 / 64);
        CHECK(std::count(all.rewritten.begin(), all.rewritten.end(), all.lines[0]) == 1);
        const Log corner = read_again(architecture, [](Machine& machine) {
            machine.registers.scissor = {.x = 60, .y = 60, .width = 4, .height = 4};
            machine.clear();
        });
        CHECK(corner.rewritten.size() == 1);
    }
}

TEST_CASE("Stencil values that a failed test writes are new to who reads them", "[rewritten]") {
    const auto fails = [](StencilOp op) {
        return [op](Machine& machine) {
            Registers& registers = machine.registers;
            registers.targets.depth = registers.targets.color[0];
            registers.targets.depth.format = Format::Depth24Stencil8;
            registers.targets.color[0] = {};
            const StencilFace face{.compare = Compare::Never, .fail = op};
            registers.stencil = {.enable = true, .front = face, .back = face};
            machine.lanes_written = 0;
            machine.draw(0, 0, 8);
        };
    };
    for (const Architecture architecture : Architectures) {
        const Log log = read_again(architecture, fails(StencilOp::Replace));
        CHECK(log.rewritten == Lines{log.lines[0]});
        CHECK(read_again(architecture, fails(StencilOp::Keep)).rewritten.empty());
    }
}

TEST_CASE("What no pixel was drawn into stays", "[rewritten]") {
    const std::vector<std::function<void(Machine&)>> writes = {
        [](Machine& machine) {
            machine.lanes_written = 0;
            machine.draw(0, 0, 8);
        },
        [](Machine& machine) {
            machine.registers.blend.write_mask = 0;
            machine.draw(0, 0, 8);
        },
        [](Machine& machine) {
            machine.registers.blend.write_mask = 0;
            machine.clear();
        },
        [](Machine& machine) {
            machine.registers.scissor.width = 0;
            machine.clear();
        }};
    for (const Architecture architecture : Architectures)
        for (const auto& write : writes)
            CHECK(read_again(architecture, write).rewritten.empty());
}

} // namespace
} // namespace ffgpu::work
