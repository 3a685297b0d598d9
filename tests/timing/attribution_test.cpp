// Every command of a frame is listed with its own cycles, and the listed cycles are the frame's.

#include "tests/support/drawn_quad.h"
#include "tests/timing/machine_figures.h"

#include <numeric>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr DeviceAddress TargetAt = 1 << 26;
constexpr unsigned Size = 64;

std::shared_ptr<Registers> target_state() {
    auto state = std::make_shared<Registers>();
    state->targets.color[0] = {.address = TargetAt,
                               .format = Format::Rgba8,
                               .width = Size,
                               .height = Size,
                               .stride = 4 * Size};
    state->scissor = {0, 0, Size, Size};
    return state;
}

class Frame {
public:
    // Quads of the lowest rows, as many as wanted; `dead`: no fragment of theirs passes.
    void draw(unsigned quads, bool dead = false) {
        add(WorkKind::Draw).geometry = {.vertex_bytes = 16,
                                        .vertices = {0, 1, 2},
                                        .primitives = {{.last_vertex = 2, .pieces = 1}},
                                        .pieces = {{0, 0, Size, Size}}};
        if (quads == 0) return;
        if (bin.tiles.empty()) bin.tiles.emplace_back();
        WorkBatch& batch = bin.tiles[0].batches.emplace_back();
        batch.draw = bin.draws.back().number;
        const std::uint8_t passed = dead ? 0 : 15;
        for (unsigned i = 0; i < quads; ++i) {
            WorkQuad& quad = batch.quads.emplace_back(drawn_quad(2 * i % Size, 2 * i / Size * 2));
            quad.after_alpha = quad.after_stencil = quad.after_depth = passed;
        }
    }
    void clear() { add(WorkKind::Clear).clear.color = true; }
    void copy() {
        CopyRectangleCommand& copy = add(WorkKind::Copy).copy;
        copy.source = state_->targets.color[0];
        copy.destination = copy.source;
        copy.destination.address = TargetAt << 1;
        copy.width = copy.height = Size;
    }

    FrameTiming run(const TimingConfig& config = {}) const {
        FrameTiming result;
        GpuTiming timing(config);
        timing.set_on_frame([&](const FrameTiming& frame) { result = frame; });
        work::CommandAssembler assembler(timing);
        assembler.bin(std::make_shared<const WorkBin>(bin));
        assembler.end_frame(0);
        return result;
    }

    WorkBin bin;

private:
    WorkDraw& add(WorkKind kind) {
        const auto number = static_cast<std::uint32_t>(bin.draws.size());
        WorkDraw& draw = bin.draws.emplace_back();
        draw.kind = kind;
        draw.number = number;
        draw.state = state_;
        return draw;
    }

    std::shared_ptr<Registers> state_ = target_state();
};

std::uint64_t sum(const FrameTiming& frame) {
    return std::accumulate(
        frame.commands.begin(),
        frame.commands.end(),
        std::uint64_t{0},
        [](std::uint64_t before, const CommandCycles& command) { return before + command.cycles; });
}

TEST_CASE("Draws without a retired quad, clears and copies are listed, and all cycles are theirs") {
    const Architecture architecture = GENERATE(Architecture::Immediate, Architecture::TileBased);
    Frame frame;
    frame.draw(0);
    frame.clear();
    frame.draw(100);
    frame.draw(0);
    frame.draw(50, true);
    frame.copy();
    frame.draw(10);
    TimingConfig config;
    config.raster.architecture = architecture;
    const FrameTiming timed = frame.run(config);
    constexpr CommandKind Draw = CommandKind::Draw;
    const std::vector<CommandKind> expected{
        Draw, CommandKind::Clear, Draw, Draw, Draw, CommandKind::Copy, Draw, CommandKind::FrameEnd};
    REQUIRE(timed.commands.size() == expected.size());
    for (std::uint32_t i = 0; i < expected.size(); ++i) {
        CHECK(timed.commands[i].kind == expected[i]);
        if (expected[i] != CommandKind::FrameEnd) CHECK(timed.commands[i].number == i);
    }
    CHECK(sum(timed) == timed.cycles);
    for (const CommandCycles& command : timed.commands)
        CHECK(std::accumulate(command.waited.begin(), command.waited.end(), std::uint64_t{0}) ==
              command.cycles);
}

TEST_CASE("The bytes of commands are all that memory moved, each in the cycles of one command") {
    const Architecture architecture = GENERATE(Architecture::Immediate, Architecture::TileBased);
    Frame frame;
    frame.clear();
    frame.draw(100);
    frame.copy();
    frame.draw(10);
    frame.draw(50, true);
    TimingConfig config;
    config.raster.architecture = architecture;
    FrameTiming timed;
    GpuTiming timing(config);
    timing.set_on_frame([&](const FrameTiming& ended) { timed = ended; });
    work::CommandAssembler assembler(timing);
    assembler.bin(std::make_shared<const WorkBin>(frame.bin));
    assembler.end_frame(0);
    const Figures figures = figures_of(timing);
    for (std::size_t i = 0; i < Clients; ++i) {
        MovedBytes sum;
        for (const CommandCycles& command : timed.commands) {
            sum.read += command.moved[i].read;
            sum.written += command.moved[i].written;
        }
        const std::string client = "memory_" + std::string(ClientNames[i]);
        INFO(client);
        CHECK(sum.read == figures.at(client + "_read_bytes"));
        CHECK(sum.written == figures.at(client + "_written_bytes"));
    }
    CHECK(figures.at("memory_color_written_bytes") > 0);
}

TEST_CASE("Bytes go to whom the cycle is charged to in which they were moved") {
    CommandLedger ledger;
    const std::size_t first = ledger.open(CommandKind::Draw, 0, 2);
    const std::size_t second = ledger.open(CommandKind::Draw, 1, 2);
    const auto move = [&](Client client, bool write, std::uint32_t bytes, std::uint64_t now) {
        ledger.moved({.bytes = bytes, .write = write, .client = client}, now);
    };
    move(Client::Texture, false, 64, 3);
    ledger.retire(first, 5);
    move(Client::Depth, true, 32, 5); // still in its last cycle
    move(Client::Color, false, 16, 6);
    ledger.retire(second, 9);
    ledger.retire(first, 9); // A command before takes the cycles over, and what they moved.
    move(Client::Color, true, 8, 10);
    ledger.retire(second, 12);
    move(Client::Host, true, 4, 13);
    const std::vector<CommandCycles> commands = ledger.end_frame(15, {});
    REQUIRE(commands.size() == 3);
    const auto moved = [&](std::size_t command, Client client) {
        return commands[command].moved[static_cast<std::size_t>(client)];
    };
    CHECK(moved(0, Client::Texture) == MovedBytes{64, 0});
    CHECK(moved(0, Client::Depth) == MovedBytes{0, 32});
    CHECK(moved(0, Client::Color) == MovedBytes{16, 0});
    CHECK(moved(1, Client::Color) == MovedBytes{0, 8});
    CHECK(moved(2, Client::Host) == MovedBytes{0, 4});
    CHECK(moved(1, Client::Host) == MovedBytes{});
    CHECK(moved(1, Client::Depth) == MovedBytes{});
}

TEST_CASE("A clear's cycles are its own: a line a cycle, and the draw after it is not charged") {
    Frame with_clear, with_two;
    with_clear.clear();
    with_two.clear();
    with_two.clear();
    for (Frame* const frame : {&with_clear, &with_two})
        frame->draw(0);
    constexpr std::uint64_t Lines = Size * Size * 4 / 64;
    TimingConfig fast;
    fast.memory.profile = MemoryProfile::Ideal; // No row that the clear leaves open is in the way.
    fast.memory.apply_profile();
    fast.memory.channels = 16;
    fast.memory.interleave_bytes = 64;
    fast.memory.bytes_per_cycle = 256;
    const FrameTiming cleared = with_clear.run(fast), twice = with_two.run(fast);
    CHECK(cleared.commands[0].cycles >= Lines);
    CHECK(cleared.commands[0].cycles <= Lines + 2 + Lines / 20);
    // However much was cleared before it.
    CHECK(cleared.commands[1].cycles == twice.commands[2].cycles);
    // Nor does it differ from one alone, but that it was on the bus before, and that its vertices
    // are read behind the clear's last line.
    Frame alone;
    alone.draw(0);
    const CommandCycles behind = cleared.commands[1], first = alone.run(fast).commands[0];
    const auto host = static_cast<std::size_t>(Resource::Host);
    const auto bandwidth = static_cast<std::size_t>(Resource::MemoryBandwidth);
    CHECK(behind.waited[host] == 0);
    CHECK(behind.waited[bandwidth] == first.waited[bandwidth] + 1);
    CHECK(behind.cycles == first.cycles - first.waited[host] + 1);
}

} // namespace
} // namespace ffgpu::timing
