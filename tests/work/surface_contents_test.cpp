// Values in the work stream: who follows them knows every byte of the targets, whatever the host.

#include "model/work/machine_order.h"
#include "model/work/scene_writes.h"
#include "model/work/surface_contents.h"
#include "model/work/work_file_reader.h"
#include "tests/gpu/depth_scene.h"
#include "tests/work/recorded_work.h"

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Applies the work in the order of a machine.
class Follower : public MachineSink {
public:
    explicit Follower(const WorkConfig& config)
        : depth_lines_(config.depth_cache.line_bytes)
        , color_lines_(config.color_cache.line_bytes)
        , depths(depth_lines_)
        , colors(color_lines_) {}

    void scene(PreparedScene&& scene) override {
        for_each_write(
            scene,
            [this](const SurfaceFill& part) { fill(part); },
            [&](const PreparedQuad& quad) { write(scene, quad); });
        fills_in_scenes += scene.tiles.fills.size();
        cut_scenes += scene.tiles.passes.size() > 1;
    }
    void transfer(PreparedTransfer&& transfer) override {
        for (const SurfaceFill& part : transfer.fills)
            fill(part);
    }
    void content(PreparedContent&& told) override {
        places[told.content->surface.address] = told;
        (told.depth ? depths : colors).set(told.place, *told.content, [this](std::uint64_t) {
            ++changed_lines;
        });
    }
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

private:
    void fill(const SurfaceFill& part) {
        depths.fill(part);
        colors.fill(part);
    }

    void write(const PreparedScene& scene, const PreparedQuad& quad) {
        const PreparedDraw& draw = scene.draws[quad.draw];
        REQUIRE(draw.has_values);
        const QuadValues values = scene.values_of(scene.draws[quad.draw], quad);
        each_line(draw.depth_place, depth_lines_, [&](std::uint64_t line) {
            depths.write(draw.depth_place, quad, values.depth_words, line);
        });
        for (std::size_t i = 0; i < draw.color_places.size(); ++i)
            each_line(draw.color_places[i], color_lines_, [&](std::uint64_t line) {
                colors.write(draw.color_places[i], quad, values.colors[i], line);
            });
        ++quads;
    }

    // All lines of the surface: slow, and knows nothing of which a quad touches.
    template <class Each>
    static void each_line(const PlacedLevel& place, std::uint32_t line_bytes, Each&& each) {
        for (std::uint64_t at = 0; at < place.layer_bytes; at += line_bytes)
            each((place.base + at) / line_bytes);
    }

    std::uint32_t depth_lines_, color_lines_;

public:
    SurfaceContents depths, colors;
    std::map<DeviceAddress, PreparedContent> places;
    std::size_t quads = 0, changed_lines = 0, fills_in_scenes = 0, cut_scenes = 0;
};

std::uint32_t in_memory(FunctionalGpu& gpu, const Surface& surface, int x, int y, unsigned sample) {
    std::uint32_t word = 0;
    const std::uint32_t bytes = format_info(surface.format).block_bytes;
    const auto at = static_cast<DeviceAddress>(surface.plane(sample).address +
                                               static_cast<std::uint32_t>(y) * surface.stride +
                                               static_cast<std::uint32_t>(x) * bytes);
    gpu.read_memory(at, std::as_writable_bytes(std::span(&word, 1)).first(bytes));
    return word;
}

void check_surface_is(Follower& follower, FunctionalGpu& gpu, const Surface& surface) {
    const auto told = follower.places.find(surface.address);
    REQUIRE(told != follower.places.end());
    const bool depth = format_info(surface.format).is_depth;
    const SurfaceContents& contents = depth ? follower.depths : follower.colors;
    int wrong = 0;
    for (int y = 0; y < surface.height; ++y)
        for (int x = 0; x < surface.width; ++x)
            for (unsigned sample = 0; sample < surface.samples; ++sample)
                wrong += contents.word(told->second.place,
                                       static_cast<std::uint32_t>(x),
                                       static_cast<std::uint32_t>(y),
                                       sample) != in_memory(gpu, surface, x, y, sample);
    CHECK(wrong == 0);
}

WorkConfig config_of(std::uint32_t seed) {
    WorkConfig config;
    config.depth_cache.line_bytes = 16u << seed % 5;
    config.depth_cache.layout = static_cast<Layout>(seed % 2);
    config.color_cache.layout = static_cast<Layout>(seed / 2 % 2);
    config.raster.traversal = static_cast<Traversal>(seed % 3);
    config.raster.architecture = static_cast<Architecture>(seed / 3 % 2);
    if (seed / 6 % 2) config.tiles.parameter_buffer_bytes = 1024; // several passes a scene
    return config;
}

const std::vector<test::DepthSceneKind> Kinds{
    {},
    {Format::Depth16, Format::Rgb565, 1},
    {Format::Depth24Stencil8, Format::Rgba8, MaxSamples},
    {Format::Depth16, Format::Luminance8, 1},
    {Format::Depth16, Format::Rgb5a1, MaxSamples},
};

TEST_CASE("Values followed in a machine's order are the bytes of the targets") {
    std::size_t cut_scenes = 0; // that took several passes
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const test::DepthSceneKind& kind = Kinds[seed % Kinds.size()];
        INFO("seed " << seed);
        const WorkConfig config = config_of(seed);
        Follower follower(config);
        MachineOrder order(config, follower);
        CommandAssembler assembler(order);
        // A host that draws in many small bins.
        test::DepthScene random(seed, kind, {.tile_size = 16, .bin_bytes = 4096});
        if (seed % 4 == 0) random.frame(10); // of which the work tells nothing
        random.scene.gpu.set_work_sink(&assembler, WorkDetail::Values);
        for (int frame = 0; frame < 2; ++frame) {
            random.frame(25, seed % 3 != 0);
            random.scene.gpu.hide_from_work(true);
            const Targets& targets = random.scene.registers.targets;
            // A copy, an upload or a stencil image is told of where the target is used again.
            random.scene.gpu.hide_from_work(false);
            test::Vertex nothing{2, 2, 0, 1, 0, 0, 0, 0, 0, 0};
            random.scene.draw(PrimitiveType::Triangles, {nothing, nothing, nothing});
            random.scene.gpu.hide_from_work(true);
            check_surface_is(follower, random.scene.gpu, targets.depth);
            check_surface_is(follower, random.scene.gpu, targets.color[0]);
            random.scene.gpu.hide_from_work(false);
        }
        CHECK(follower.quads > 100);
        if (config.raster.architecture == Architecture::TileBased)
            CHECK(follower.fills_in_scenes > 0);
        cut_scenes += follower.cut_scenes;
        random.scene.gpu.set_work_sink(nullptr);
    }
    CHECK(cut_scenes > 10);
}

CommandList random_work(std::uint32_t seed,
                        const test::DepthSceneKind& kind,
                        const FunctionalGpu::Config& host,
                        WorkDetail detail = WorkDetail::Values) {
    CommandList list;
    CommandAssembler assembler(list);
    test::DepthScene random(seed, kind, host);
    random.scene.gpu.set_work_sink(&assembler, detail);
    random.frame(25);
    random.scene.gpu.set_work_sink(nullptr);
    return list;
}

TEST_CASE("Values and contents are the same whatever the host, and come back from a file") {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        INFO("seed " << seed);
        const test::DepthSceneKind& kind = Kinds[seed % Kinds.size()];
        const CommandList list = random_work(seed, kind, {});
        const CommandList other =
            random_work(seed, kind, {.threads = 3, .tile_size = 16, .bin_bytes = 4096});
        REQUIRE(list.log == other.log);
        for (std::size_t i = 0; i < list.commands.size(); ++i) {
            CHECK(list.commands[i]->value_begin == other.commands[i]->value_begin);
            CHECK((list.commands[i]->values == other.commands[i]->values));
        }
        REQUIRE(list.contents.size() == other.contents.size());
        for (std::size_t i = 0; i < list.contents.size(); ++i)
            CHECK((list.contents[i]->bytes == other.contents[i]->bytes));

        const TemporaryFile file(file_of(list), ".ffw");
        CommandList read;
        WorkFileReader(file.path()).play(read, [](const FrameFigures&) {});
        REQUIRE(read.commands.size() == list.commands.size());
        for (std::size_t i = 0; i < list.commands.size(); ++i) {
            CHECK(list.commands[i]->value_begin == read.commands[i]->value_begin);
            CHECK((list.commands[i]->values == read.commands[i]->values));
        }
        REQUIRE(read.contents.size() == list.contents.size());
        for (std::size_t i = 0; i < list.contents.size(); ++i) {
            CHECK(read.contents[i]->surface == list.contents[i]->surface);
            CHECK((read.contents[i]->bytes == list.contents[i]->bytes));
        }
    }
}

TEST_CASE("Values change nothing else of the work but the texels of hidden fragments") {
    const CommandList plain = random_work(3, {}, {}, WorkDetail::Masks);
    const CommandList values = random_work(3, {}, {});
    REQUIRE(plain.commands.size() == values.commands.size());
    for (std::size_t i = 0; i < plain.commands.size(); ++i) {
        CHECK_FALSE(plain.commands[i]->has_values());
        CHECK((plain.commands[i]->quads == values.commands[i]->quads));
    }
}

} // namespace
} // namespace ffgpu::work
