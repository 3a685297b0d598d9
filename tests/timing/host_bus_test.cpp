// The host's bus, what goes over it to memory, and the screen: cycles and bytes against closed
// forms.

#include "model/timing/memory/lost_cycles.h"
#include "tests/timing/analytic_scenes.h"
#include "tests/timing/front_end_scenes.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

WorkBin draws(std::uint32_t count, std::uint32_t writes, std::uint32_t words) {
    WorkBin bin;
    for (std::uint32_t i = 0; i < count; ++i) {
        WorkDraw& draw = bin.draws.emplace_back();
        draw.number = i;
        draw.state = std::make_shared<Registers>();
        draw.register_writes = writes;
        draw.register_words = words;
    }
    return bin;
}

TEST_CASE("a draw takes the bus its command's bytes and those of the registers written before it") {
    const auto make = [](std::uint32_t count) { return draws(count, 10, 30); };
    TimingConfig config = wide_front_end();
    config.command_processor.draw_cycles = 16;
    config.host.command_bytes = 32;
    config.host.register_bytes = 8;
    constexpr std::uint64_t Bytes = 32 + 10 * 8 + 30 * 4;
    for (const std::uint32_t bytes : {1u, 3u, 8u}) {
        config.host.bytes_per_cycle = bytes;
        INFO(bytes << " bytes a cycle");
        // What one command leaves of a cycle is the next one's.
        CHECK(static_cast<double>(cycles_of_1000(config, make)) ==
              Approx(1000.0 * Bytes / bytes).margin(1));
    }
    CHECK(run(config, make(100)).at("host_command_bytes") == 100 * Bytes + 32); // and the frame's
    for (const std::uint32_t bytes : {0u, 64u}) {
        config.host.bytes_per_cycle = bytes; // Decoding is slower.
        CHECK(cycles_of_1000(config, make) == 16000);
    }
}

FrameTiming frame_of(const TimingConfig& config, const WorkBin& bin, Figures& figures) {
    FrameTiming result;
    GpuTiming timing(config);
    timing.set_on_frame([&](const FrameTiming& frame) { result = frame; });
    work::CommandAssembler assembler(timing);
    assembler.bin(std::make_shared<const WorkBin>(bin));
    assembler.end_frame(0);
    figures = figures_of(timing);
    return result;
}

TEST_CASE("an upload crosses the bus and is written to memory, in its place, its cycles its own") {
    WorkBin bin = draws(2, 0, 0);
    bin.transfers.push_back({.before_draw = 1, .is_write = true, .at = 4096 + 10, .bytes = 65536});
    TimingConfig config = wide_front_end();
    config.host.bytes_per_cycle = 8;
    Figures figures;
    const FrameTiming frame = frame_of(config, bin, figures);
    REQUIRE(frame.commands.size() == 4);
    CHECK(frame.commands[1].kind == CommandKind::HostWrite);
    CHECK(frame.commands[1].number == 1);
    CHECK(static_cast<double>(frame.commands[1].cycles) == Approx(65536 / 8).epsilon(0.01));
    CHECK(figures.at("memory_host_written_bytes") == 65536);
    CHECK(figures.at("memory_host_requests") == 1025); // Cut at multiples of 64.
    CHECK(figures.at("host_written_bytes") == 65536);
}

TEST_CASE("without a limit of the bus, memory bounds an upload") {
    WorkBin bin = draws(1, 0, 0);
    bin.transfers.push_back({.is_write = true, .at = 4096, .bytes = 1 << 20});
    TimingConfig config = wide_front_end();
    config.memory.channels = 1;
    config.memory.bytes_per_cycle = 4;
    const double cycles = static_cast<double>(run(config, bin).at("total_cycles"));
    CHECK(cycles == Approx((1 << 20) / 4).epsilon(0.02));
}

TEST_CASE("a read by the driver waits for the pipe, reads memory and comes back over the bus") {
    WorkBin bin = make_bin(planar_scene(64));
    bin.transfers.push_back({.before_draw = 1, .is_write = false, .at = 1 << 26, .bytes = 16384});
    TimingConfig config = wide_front_end();
    config.host.bytes_per_cycle = 2;
    Figures figures;
    const FrameTiming frame = frame_of(config, bin, figures);
    REQUIRE(frame.commands.size() == 3);
    CHECK(frame.commands[1].kind == CommandKind::HostRead);
    CHECK(static_cast<double>(frame.commands[1].cycles) == Approx(16384 / 2).epsilon(0.05));
    CHECK(figures.at("memory_host_read_bytes") == 16384);
    // The picture was written before: at the frame's end nothing is left.
    CHECK(figures.at("memory_color_written_bytes") == 64 * 64 * 4);
    CHECK(frame.commands[2].cycles < 100);
    bin.transfers[0].bytes = 0;
    CHECK(frame_of(config, bin, figures).commands.size() == 3);
}

TEST_CASE("an image fetches the rows of memory that it reads") {
    WorkBin bin = make_bin(planar_scene(16));
    bin.draws[0].kind = WorkKind::Image;
    bin.draws[0].image = {
        .format = Format::Rgba8, .address = 1 << 20, .stride = 512, .width = 100, .height = 50};
    for (WorkBatch& batch : bin.tiles[0].batches)
        batch.textures.clear();
    CHECK(run(wide_front_end(), bin).at("memory_command_read_bytes") == 50 * 400);
}

TEST_CASE("the screen reads the shown surface once a refresh, evenly, and no frame waits for it") {
    const WorkBin bin = make_bin(planar_scene(128)); // 65,536 bytes of colour: 1024 lines
    const auto figures = [&](std::uint32_t refresh, std::uint32_t order) {
        TimingConfig config = wide_front_end();
        config.memory.channels = 1;
        config.memory.bytes_per_cycle = 64;
        config.host.bytes_per_cycle = 8;
        config.scan_out.refresh_cycles = refresh;
        GpuTiming timing(config, order);
        work::CommandAssembler assembler(timing);
        for (std::uint32_t frame = 0; frame < 3; ++frame) {
            WorkBin shown = bin; // The first frame shows nothing yet.
            shown.transfers.push_back({.at = 4096, .bytes = 1 << 17});
            assembler.bin(std::make_shared<const WorkBin>(shown));
            assembler.end_frame(frame);
        }
        return figures_of(timing);
    };
    const Figures off = figures(0, 0);
    CHECK(off.at("memory_scan_out_read_bytes") == 0);
    for (const std::uint32_t refresh : {3000u, 20000u}) {
        const Figures on = figures(refresh, 0);
        const double two_frames = static_cast<double>(on.at("total_cycles")) * 2 / 3;
        INFO("refresh " << refresh);
        CHECK(static_cast<double>(on.at("memory_scan_out_read_bytes")) ==
              Approx(65536 * two_frames / refresh).epsilon(0.03));
        CHECK(on.at("scan_out_refreshes") == static_cast<std::uint64_t>(two_frames / refresh));
        CHECK(figures(refresh, 4) == on);
        CHECK(static_cast<double>(on.at("total_cycles")) ==
              Approx(off.at("total_cycles")).epsilon(0.05));
    }
    // What the bus still carries for the screen at a frame's end is of the next frame.
    for (std::uint32_t refresh = 700; refresh < 1700; refresh += 53) {
        const Figures on = figures(refresh, 0);
        std::uint64_t cycles = on.at("memory_data_cycles");
        for (const std::string_view cause : LostToNames)
            cycles += on.at("memory_lost_" + std::string(cause) + "_cycles");
        INFO("refresh " << refresh);
        CHECK(cycles == on.at("memory_bus_cycles"));
    }
}

TEST_CASE("a front end whose queues hold one entry ends, in every order of evaluation alike") {
    WorkBin bin = triangles(50, {.pieces = 2, .planes = 1});
    bin.draws[0].geometry.index_bytes = 2;
    bin.draws[0].geometry.index_address = 1 << 20;
    bin.draws[0].register_writes = 3;
    WorkDraw image;
    image.kind = WorkKind::Image;
    image.number = 1;
    image.state = bin.draws[0].state;
    image.image = {.address = 1 << 21, .stride = 64, .width = 16, .height = 16};
    bin.draws.push_back(image);
    bin.transfers.push_back({.before_draw = 0, .at = 100, .bytes = 1000});
    bin.transfers.push_back({.before_draw = 1, .is_write = false, .at = 100, .bytes = 1000});
    bin.transfers.push_back({.before_draw = 2, .at = 1 << 20, .bytes = 100});
    TimingConfig config;
    config.host.queue = config.clip.queue = config.setup.queue = config.raster.queue = 1;
    config.vertex.index_queue = config.vertex.fetch_queue = config.vertex.order_entries = 1;
    config.vertex.index_cache_lines = 1;
    config.memory.queue = config.memory.client_queue = 1;
    config.scan_out.refresh_cycles = 5000;
    config.scan_out.queue = 1;
    for (const std::uint32_t units : {1u, 3u}) {
        config.vertex.units = config.setup.units = config.vertex.vertices_per_cycle = units;
        const Figures figures = run(config, bin);
        CHECK(figures.at("vertex_vertices") == 150);
        CHECK(figures.at("memory_host_written_bytes") == 1100);
        CHECK(figures.at("memory_host_read_bytes") == 1000);
        CHECK(figures.at("memory_command_read_bytes") == 16 * 64);
        for (const std::uint32_t order : {1u, 2u, 3u})
            CHECK(run(config, bin, order) == figures);
        config.vertex.index_cache_lines = 0;
        CHECK(run(config, bin, 1) == run(config, bin, 2));
    }
}

} // namespace
} // namespace ffgpu::timing
