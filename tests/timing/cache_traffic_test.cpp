// The bytes that draws, clears and copies move, on the whole machine. What is expected comes from
// coordinates and from the layout's formula, written once more here.

#include "tests/timing/machine_figures.h"

#include <map>
#include <random>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr DeviceAddress ColorAddress = 1 << 26, DepthAddress = 1 << 27;

// Byte `i` of pixel (x, y) of a blocked surface: blocks in row order, rows of a block inside.
struct BlockedBytes {
    unsigned width, block, element;

    unsigned offset(unsigned x, unsigned y) const {
        const unsigned across = (width + block - 1) / block;
        const unsigned number = y / block * across + x / block;
        return element * (number * block * block + y % block * block + x % block);
    }
};

struct Area {
    unsigned x, y, width, height;
};

std::shared_ptr<Registers> targets(unsigned width, unsigned height) {
    auto state = std::make_shared<Registers>();
    state->targets.color[0] = {.address = ColorAddress,
                               .format = Format::Rgba8,
                               .width = static_cast<std::uint16_t>(width),
                               .height = static_cast<std::uint16_t>(height),
                               .stride = 4 * width};
    return state;
}

// A draw that writes the pixels for which `covers` says so.
template <class Covers>
void add_draw(WorkBin& bin, std::shared_ptr<Registers> state, Covers&& covers) {
    const Surface& target = state->targets.color[0];
    const auto number = static_cast<std::uint32_t>(bin.draws.size());
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = state;
    draw.number = number;
    if (bin.tiles.empty()) bin.tiles.emplace_back();
    WorkBatch& batch = bin.tiles[0].batches.emplace_back();
    batch.draw = number;
    for (unsigned y = 0; y < target.height; y += 2) {
        for (unsigned x = 0; x < target.width; x += 2) {
            std::uint8_t lanes = 0;
            for (unsigned lane = 0; lane < 4; ++lane)
                if (covers(x + lane % 2, y + lane / 2))
                    lanes |= static_cast<std::uint8_t>(1 << lane);
            if (lanes == 0) continue;
            batch.quads.push_back({.primitive = 0,
                                   .x = static_cast<std::uint16_t>(x),
                                   .y = static_cast<std::uint16_t>(y),
                                   .covered = lanes,
                                   .after_early_depth = lanes,
                                   .after_coverage = lanes,
                                   .after_alpha = lanes,
                                   .after_stencil = lanes,
                                   .after_depth = lanes});
        }
    }
}

void add_clear(WorkBin& bin, std::shared_ptr<Registers> state, const Area& area, unsigned mask) {
    auto clearing = std::make_shared<Registers>(*state);
    clearing->scissor = {static_cast<std::int16_t>(area.x),
                         static_cast<std::int16_t>(area.y),
                         static_cast<std::uint16_t>(area.width),
                         static_cast<std::uint16_t>(area.height)};
    clearing->blend.write_mask = static_cast<std::uint8_t>(mask);
    const auto number = static_cast<std::uint32_t>(bin.draws.size());
    WorkDraw& clear = bin.draws.emplace_back();
    clear.kind = WorkKind::Clear;
    clear.number = number;
    clear.state = clearing;
    clear.clear.color = true;
}

TEST_CASE("a scissored clear keeps the dirty lines outside its rectangle") {
    auto state = targets(64, 64);
    WorkBin bin;
    add_draw(bin, state, [](unsigned, unsigned) { return true; });
    add_clear(bin, state, {0, 0, 1, 1}, 15);
    const Figures figures = run(TimingConfig{}, bin);
    CHECK(figures.at("memory_color_written_bytes") == 64 * 64 * 4);
    CHECK(figures.at("memory_command_written_bytes") == 4);
}

TEST_CASE("a clear of whole lines drops them, a clear of one row less writes that block row back") {
    for (const unsigned height : {7u, 8u}) {
        auto state = targets(64, 64);
        WorkBin bin;
        add_draw(bin, state, [](unsigned, unsigned) { return true; });
        add_clear(bin, state, {0, 0, 64, height}, 15);
        const Figures figures = run(TimingConfig{}, bin);
        INFO(height);
        const unsigned dropped_rows = height / 4 * 4;
        CHECK(figures.at("memory_color_written_bytes") == (64 - dropped_rows) * 64 * 4);
        CHECK(figures.at("memory_command_written_bytes") == height * 64 * 4);
    }
}

TEST_CASE("a masked clear keeps the dirty lines") {
    auto state = targets(64, 64);
    WorkBin bin;
    add_draw(bin, state, [](unsigned, unsigned) { return true; });
    add_clear(bin, state, {0, 0, 64, 64}, 7);
    const Figures figures = run(TimingConfig{}, bin);
    CHECK(figures.at("memory_color_written_bytes") == 64 * 64 * 4);
}

// A surface of random size and layout, draws and clears of random rectangles, and what memory must
// see of them if the cache is big enough to keep every line.
class RandomScene {
public:
    explicit RandomScene(unsigned seed)
        : random_(seed)
        , layout_{8 + 2 * below(20), 2u << below(3), 4}
        , height_(8 + 2 * below(20))
        , state(targets(layout_.width, height_)) {
        line_ = std::min(64u, layout_.block * layout_.block * 4);
        for (int i = 0; i < 3; ++i) {
            draw();
            clear();
        }
        for (const auto& [number, bytes] : dirty_)
            written_back += bytes.size();
    }

    TimingConfig config() const {
        TimingConfig config;
        config.color_cache.block_width = layout_.block;
        config.color_cache.line_bytes = line_;
        config.color_cache.transfer_bytes = 1;
        config.color_cache.sets = 1;
        config.color_cache.ways = 2048;
        return config;
    }

private:
    using Lines = std::map<unsigned, std::set<unsigned>>; // bytes by line

    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }

    Area random_area() {
        const unsigned x = below(layout_.width), y = below(height_);
        return {x, y, 1 + below(layout_.width - x), 1 + below(height_ - y)};
    }

    // Of the area's pixels (x + y divisible by `every`) the bytes of `mask`.
    Lines lines_of(const Area& area, unsigned mask, unsigned every) const {
        Lines lines;
        for (unsigned y = area.y; y < area.y + area.height; ++y)
            for (unsigned x = area.x; x < area.x + area.width; ++x)
                for (unsigned byte = 0; byte < 4; ++byte) {
                    const unsigned at = layout_.offset(x, y) + byte;
                    if ((mask >> byte & 1) && (x + y) % every == 0)
                        lines[at / line_].insert(at % line_);
                }
        return lines;
    }

    void draw() {
        const Area area = random_area();
        const unsigned every = 1 + below(3);
        add_draw(bin, state, [&](unsigned x, unsigned y) {
            return x >= area.x && x < area.x + area.width && y >= area.y &&
                   y < area.y + area.height && (x + y) % every == 0;
        });
        for (const auto& [number, bytes] : lines_of(area, 15, every))
            dirty_[number].insert(bytes.begin(), bytes.end());
    }

    void clear() {
        const Area area = random_area();
        const unsigned mask = below(2) ? 15 : below(16);
        add_clear(bin, state, area, mask);
        for (const auto& [number, bytes] : lines_of(area, mask, 1)) {
            if (bytes.size() < line_) written_back += dirty_[number].size();
            dirty_.erase(number);
            cleared += bytes.size();
        }
    }

    std::mt19937 random_;
    BlockedBytes layout_;
    unsigned height_;
    unsigned line_ = 0;
    Lines dirty_;

public:
    std::shared_ptr<Registers> state;
    WorkBin bin;
    std::uint64_t written_back = 0, cleared = 0;
};

TEST_CASE("dirty bytes in are bytes out, over random scissored and masked clears") {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const RandomScene scene(seed);
        const Figures figures = run(scene.config(), scene.bin);
        INFO("seed " << seed);
        CHECK(figures.at("memory_color_written_bytes") == scene.written_back);
        CHECK(figures.at("memory_command_written_bytes") == scene.cleared);
        CHECK(figures.at("color_cache_written_bytes") == scene.written_back);
        CHECK(figures.at("color_cache_dirtied_bytes") ==
              scene.written_back + figures.at("color_cache_dropped_bytes"));
        CHECK(figures.at("color_cache_conflict_misses") == 0);
    }
}

TEST_CASE("unblended pixels are written alone: every fourth pixel is a quarter of the bytes") {
    auto state = targets(256, 256);
    WorkBin bin;
    add_draw(bin, state, [](unsigned x, unsigned y) { return x % 2 == 0 && y % 2 == 0; });
    const Figures figures = run(TimingConfig{}, bin);
    CHECK(figures.at("memory_color_written_bytes") == 256 * 256);
    CHECK(figures.at("memory_color_read_bytes") == 0);
}

TEST_CASE("a copy reads the lines of its source rectangle and writes the pixels of its other") {
    auto state = targets(64, 64);
    WorkBin bin;
    add_draw(bin, state, [](unsigned, unsigned) { return true; });
    WorkDraw& draw = bin.draws.emplace_back();
    draw.kind = WorkKind::Copy;
    draw.number = 1;
    draw.copy.source = state->targets.color[0];
    draw.copy.destination = draw.copy.source;
    draw.copy.destination.address = DepthAddress;
    draw.copy.source_x = 3; // Blocks of 4x4 pixels: columns 0 to 2, row 1 to 2.
    draw.copy.source_y = 5;
    draw.copy.destination_x = draw.copy.destination_y = 1;
    draw.copy.width = 6;
    draw.copy.height = 4;
    const Figures figures = run(TimingConfig{}, bin);
    CHECK(figures.at("memory_color_written_bytes") == 64 * 64 * 4);
    CHECK(figures.at("memory_command_read_bytes") == 3 * 2 * 64);
    CHECK(figures.at("memory_command_written_bytes") == 6 * 4 * 4);
}

TEST_CASE("a vertex that the host rewrites is fetched again, its neighbours are not") {
    GpuTiming timing{TimingConfig{}};
    work::CommandAssembler assembler(timing);
    for (int i = 0; i < 4; ++i) {
        WorkBin bin;
        WorkDraw& draw = bin.draws.emplace_back();
        draw.state = std::make_shared<Registers>();
        draw.number = static_cast<std::uint32_t>(i);
        draw.geometry.vertex_bytes = 64;
        draw.geometry.vertex_address = 4096;
        draw.geometry.vertices = {0, 1, 2};
        draw.geometry.primitives = {{.last_vertex = 0, .fate = PrimitiveFate::Culled}};
        bin.transfers.push_back({.at = 4096 + 64, .bytes = 64});
        assembler.bin(std::make_shared<const WorkBin>(bin));
    }
    assembler.end_frame(0);
    const Figures figures = figures_of(timing);
    CHECK(figures.at("memory_vertex_read_bytes") == (3 + 3) * 64);
    CHECK(figures.at("vertex_cache_conflict_misses") == 0);
}

TEST_CASE("a fully associative cache has no conflict miss in the frame after a flush") {
    TimingConfig config;
    config.color_cache.sets = 1;
    config.color_cache.ways = 64;
    auto state = targets(32, 32);
    state->blend.enable = true;
    state->blend.rgb_destination = BlendFactor::One;
    GpuTiming timing(config);
    work::CommandAssembler assembler(timing);
    WorkBin bin;
    add_draw(bin, state, [](unsigned, unsigned) { return true; });
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
        assembler.bin(std::make_shared<const WorkBin>(bin));
        assembler.end_frame(frame);
    }
    const Figures figures = figures_of(timing);
    CHECK(figures.at("color_cache_misses") == 3 * 64);
    CHECK(figures.at("color_cache_conflict_misses") == 0);
    CHECK(figures.at("color_cache_compulsory_misses") == 3 * 64);
}

} // namespace
} // namespace ffgpu::timing
