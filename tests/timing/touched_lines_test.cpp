// Every line on which a touched pixel lies is accessed, whatever the layout, the line and the
// samples. The lines are computed here from coordinates and the layouts' definitions.

#include "model/packets/quad_values.h"
#include "tests/timing/machine_figures.h"

#include <algorithm>
#include <bit>
#include <random>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// A surface as the machine lays it out: its first byte begins a line.
struct Shape {
    unsigned width = 0, height = 0, samples = 1;
    Layout layout = Layout::Linear;
    unsigned block = 4;
    unsigned line = 64;

    unsigned pixel_bytes() const { return 4 * samples; }

    unsigned offset(unsigned x, unsigned y) const {
        const bool linear = layout == Layout::Linear || width < block || height < block;
        if (linear) return pixel_bytes() * (y * width + x);
        const unsigned across = (width + block - 1) / block;
        const unsigned before = (y / block * across + x / block) * block * block;
        return pixel_bytes() * (before + y % block * block + x % block);
    }
};

class Lines {
public:
    void add(const Shape& shape, unsigned x, unsigned y) {
        for (unsigned byte = 0; byte < shape.pixel_bytes(); ++byte)
            lines_.insert((shape.offset(x, y) + byte) / shape.line);
    }
    std::uint64_t bytes(const Shape& shape) const { return lines_.size() * shape.line; }

private:
    std::set<unsigned> lines_;
};

struct Fragments {
    bool covered = false, after_alpha = false, written = false;
};

void apply(const Shape& shape, CacheConfig& cache) {
    cache.layout = shape.layout;
    cache.block_width = shape.block;
    cache.line_bytes = shape.line;
    cache.sets = 1;
    cache.ways = 8192; // Everything stays: each line is fetched once.
}

// One draw of random fragments, with depth test and blending, and the bytes that it must fetch.
class RandomDraw {
public:
    explicit RandomDraw(unsigned seed)
        : random_(seed)
        , early_(below(2) == 0)
        , density_(1 + below(8)) {
        color_.width = depth_.width = 2 + 2 * below(24);
        color_.height = depth_.height = 2 + 2 * below(24);
        color_.samples = depth_.samples = below(2) ? MaxSamples : 1;
        for (Shape* const shape : {&color_, &depth_}) {
            shape->layout = below(2) ? Layout::Blocked : Layout::Linear;
            shape->block = 1u << below(5);
            shape->line = 16u << below(5);
        }
        make();
    }

    TimingConfig config() const {
        TimingConfig config;
        apply(color_, config.color_cache);
        apply(depth_, config.depth_cache);
        config.color_cache.write_miss = WriteMiss::FetchOnWrite;
        config.memory.interleave_bytes = 256;
        return config;
    }

    // Each quad moves its own pixels; draws that test late.
    bool tests_late() const { return !early_; }
    TimingConfig config_without_caches() const {
        TimingConfig config = this->config();
        config.color_cache.enable = config.depth_cache.enable = false;
        config.depth.test = work::DepthTest::Late;
        return config;
    }

    WorkBin bin;
    std::uint64_t color_bytes() const { return color_lines_.bytes(color_); }
    std::uint64_t depth_bytes() const { return depth_lines_.bytes(depth_); }
    // Lines of each quad, summed over the quads, and the pixels that are written.
    std::uint64_t color_bytes_by_quad() const { return quads_color_bytes_; }
    std::uint64_t depth_bytes_by_quad() const { return quads_depth_bytes_; }
    std::uint64_t stored_color_bytes() const { return written_ * color_.pixel_bytes(); }

private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }

    Surface target(DeviceAddress address, Format format) const {
        return {.address = address,
                .format = format,
                .width = static_cast<std::uint16_t>(color_.width),
                .height = static_cast<std::uint16_t>(color_.height),
                .stride = color_.width * color_.pixel_bytes(),
                .samples = static_cast<std::uint8_t>(color_.samples)};
    }

    void make() {
        auto state = std::make_shared<Registers>();
        state->targets.color[0] = target(1 << 26, Format::Rgba8);
        state->targets.depth = target(1 << 27, Format::Depth24Stencil8);
        state->depth = {.test_enable = true, .write_enable = false};
        state->blend.enable = true;
        state->blend.rgb_destination = state->blend.alpha_destination = BlendFactor::One;
        WorkDraw& draw = bin.draws.emplace_back();
        draw.state = state;
        draw.early_depth = early_;
        WorkBatch& batch = bin.tiles.emplace_back().batches.emplace_back();
        batch.draw = 0;
        batch.value_begin.push_back(0);
        for (unsigned y = 0; y < color_.height; y += 2)
            for (unsigned x = 0; x < color_.width; x += 2)
                add_quad(batch, x, y);
    }

    void add_quad(WorkBatch& batch, unsigned x, unsigned y) {
        WorkQuad quad{};
        quad.x = static_cast<std::uint16_t>(x);
        quad.y = static_cast<std::uint16_t>(y);
        quad_color_lines_ = quad_depth_lines_ = {};
        for (unsigned lane = 0; lane < 4; ++lane)
            add_fragment(quad, lane);
        quads_color_bytes_ += quad_color_lines_.bytes(color_);
        quads_depth_bytes_ += quad_depth_lines_.bytes(depth_);
        if (quad.covered == 0) return;
        batch.quads.push_back(quad);
        add_values(batch, quad);
    }

    // Depths and colours, which nothing depends on here but that they are told.
    void add_values(WorkBatch& batch, const WorkQuad& quad) {
        const bool multisampled = color_.samples > 1;
        const int depths = std::popcount(covered_samples(quad, multisampled));
        const int colors = std::popcount(written_samples(quad, multisampled));
        batch.values.resize(batch.values.size() + static_cast<std::size_t>(depths + colors));
        batch.value_begin.push_back(static_cast<std::uint32_t>(batch.values.size()));
    }

    void add_fragment(WorkQuad& quad, unsigned lane) {
        if (below(8) >= density_) return;
        const auto bit = static_cast<std::uint8_t>(1u << lane);
        const unsigned x = quad.x + lane % 2, y = quad.y + lane / 2;
        const bool after_early = !early_ || below(4) > 0;
        const bool after_alpha = after_early && below(4) > 0;
        const bool written = after_alpha && (early_ || below(4) > 0);
        quad.covered |= bit;
        if (after_early) quad.after_early_depth |= bit;
        if (after_alpha) quad.after_coverage |= bit, quad.after_alpha |= bit;
        if (written) quad.after_stencil |= bit, quad.after_depth |= bit;
        if (color_.samples > 1) {
            quad.samples_covered |= static_cast<std::uint16_t>(0xfu << 4 * lane);
            if (written) quad.samples_written |= static_cast<std::uint16_t>(0xfu << 4 * lane);
        }
        for (Lines* const lines : {&depth_lines_, &quad_depth_lines_})
            if (early_ || after_alpha) lines->add(depth_, x, y);
        for (Lines* const lines : {&color_lines_, &quad_color_lines_})
            if (written) lines->add(color_, x, y);
        written_ += written;
    }

    std::mt19937 random_;
    bool early_;
    unsigned density_; // eighths
    Shape color_, depth_;
    Lines color_lines_, depth_lines_, quad_color_lines_, quad_depth_lines_;
    std::uint64_t quads_color_bytes_ = 0, quads_depth_bytes_ = 0, written_ = 0;
};

TEST_CASE("compulsory bytes are the touched lines, over random layouts, lines, blocks, samples") {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const RandomDraw draw(seed);
        const Figures figures = run(draw.config(), draw.bin);
        INFO("seed " << seed);
        CHECK(figures.at("memory_color_read_bytes") == draw.color_bytes());
        CHECK(figures.at("memory_depth_read_bytes") == draw.depth_bytes());
    }
}

TEST_CASE("without caches each quad reads all lines of its pixels and stores what it writes") {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const RandomDraw draw(seed);
        if (!draw.tests_late()) continue;
        const Figures figures = run(draw.config_without_caches(), draw.bin);
        INFO("seed " << seed);
        CHECK(figures.at("memory_color_read_bytes") == draw.color_bytes_by_quad());
        CHECK(figures.at("memory_color_written_bytes") == draw.stored_color_bytes());
        CHECK(figures.at("memory_depth_read_bytes") == draw.depth_bytes_by_quad());
    }
}

TEST_CASE("a linear depth surface is read whole: 307,200 bytes of 320x240 pixels") {
    WorkBin bin;
    auto state = std::make_shared<Registers>();
    state->targets.depth = {.address = 1 << 27,
                            .format = Format::Depth24Stencil8,
                            .width = 320,
                            .height = 240,
                            .stride = 320 * 4};
    state->depth = {.test_enable = true, .write_enable = false};
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = state;
    draw.early_depth = true;
    WorkBatch& batch = bin.tiles.emplace_back().batches.emplace_back();
    batch.draw = 0;
    for (unsigned y = 0; y < 240; y += 2) {
        for (unsigned x = 0; x < 320; x += 2) {
            WorkQuad quad{};
            quad.x = static_cast<std::uint16_t>(x);
            quad.y = static_cast<std::uint16_t>(y);
            quad.covered = quad.after_early_depth = quad.after_coverage = 15;
            quad.after_alpha = quad.after_stencil = quad.after_depth = 15;
            batch.quads.push_back(quad);
        }
    }
    TimingConfig config;
    config.depth_cache.layout = Layout::Linear;
    CHECK(run(config, bin).at("memory_depth_read_bytes") == 307'200);
}

} // namespace
} // namespace ffgpu::timing
