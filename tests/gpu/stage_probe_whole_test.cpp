// Stage probes on whole pictures: nothing changes, nothing is missing, and the order is the same.

#include "tests/gpu/busy_scene.h"

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// Everything that is told of live lanes, as one number, and how much of it.
class Digest final : public StageProbe {
public:
    std::uint64_t value = 0xcbf29ce484222325; // FNV-1a
    std::map<std::string, std::uint64_t> calls;
    std::uint64_t records = 0, covered = 0, written = 0;

    void set_up(const probed::SetUp& told) override {
        begin("set_up");
        add(told.draw);
        add(told.primitive->key);
        add(told.record != nullptr);
        ++records;
    }
    void coverage(const probed::Batch& batch, const probed::Coverage& told) override {
        covered += batch.fragments->live.count();
        begin("coverage");
        live(batch, [&](unsigned lane) {
            const FragmentKey key = probed::key_of(batch, lane);
            add(key.draw);
            add(key.primitive);
            add(key.sequence);
            for (const auto& edge : told.edges)
                add(static_cast<std::uint64_t>(edge[lane]));
        });
    }
    void depth(const probed::Batch& batch) override {
        begin("depth");
        live(batch, [&](unsigned lane) {
            const SampleDepths* const depths = batch.fragments->sample_depths;
            for (unsigned i = 0; i < MaxSamples; ++i)
                add(depths ? depths->of[i][lane] : batch.fragments->depth[lane]);
        });
    }
    void perspective(const probed::Batch& batch, const probed::Perspective& told) override {
        begin("perspective");
        live(batch, [&](unsigned lane) {
            add(std::bit_cast<std::uint64_t>(told.inverse_w[lane]));
            add(std::bit_cast<std::uint32_t>(told.w[lane]));
        });
    }
    void colors(const probed::Batch& batch, const probed::Colors& told) override {
        begin("colors");
        live(batch, [&](unsigned lane) {
            add(std::bit_cast<std::uint64_t>(told.primary_over_w[0][lane]));
            color(batch.fragments->primary, lane);
        });
    }
    void tex_coords(const probed::Batch& batch, const probed::TexCoords& told) override {
        begin("tex_coords");
        live(batch, [&](unsigned lane) {
            add(std::bit_cast<std::uint64_t>(told.over_w[0][lane]));
            add(std::bit_cast<std::uint32_t>(told.result->s[lane]));
        });
    }
    void sampling(const probed::Batch& batch, const probed::Sampling& told) override {
        begin("sampling");
        for (const probed::QuadLevels& quad : told.quads)
            add(static_cast<std::uint32_t>(quad.lambda));
        for (const probed::Probe& probe : told.probes) {
            add(probe.lane);
            // The stage's own result is that of the account: one probe a fragment in this scene.
            const auto& planes = *told.result;
            agreed = agreed && planes.r[probe.lane] == probe.color[0] &&
                     planes.a[probe.lane] == probe.color[3];
        }
        for (const probed::LevelFilter& filter : told.level_filters)
            add(filter.access.x0 + 65536u * filter.color[0]);
        live(batch, [&](unsigned lane) { color(*told.result, lane); });
    }
    void environment(const probed::Batch& batch, const probed::Environment&) override {
        shaded("environment", batch);
    }
    void color_sum(const probed::Batch& batch, const ColorPlanes&) override {
        shaded("color_sum", batch);
    }
    void fog(const probed::Batch& batch, const probed::Fog& told) override {
        shaded("fog", batch);
        live(batch, [&](unsigned lane) { add(told.factor[lane]); });
    }
    void antialias(const probed::Batch& batch, const ColorPlanes&) override {
        shaded("antialias", batch);
    }
    void sample_mask(const probed::Batch&, const SampleMasks& before) override {
        begin("sample_mask");
        for (const FragmentMask& one : before)
            mask(one);
    }
    void alpha_test(const probed::Batch&, const probed::Test& told) override {
        begin("alpha_test");
        mask(told.after);
    }
    void stencil_depth(const probed::Batch& batch, const probed::StencilDepth& told) override {
        begin("stencil_depth");
        mask(told.after_depth);
        for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane)
            if (told.before.test(lane)) {
                add(told.stored_depth[lane]);
                add(told.new_depth[lane] + 65536u * told.new_stencil[lane]);
            }
    }
    void color_write(const probed::Batch& batch, const probed::ColorWrite& told) override {
        begin("color_write");
        written += told.written.count();
        for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane)
            if (told.written.test(lane)) {
                add(told.destination[lane]);
                add(told.blended[lane]);
                add(told.stored[lane]);
            }
    }

    bool agreed = true;

private:
    void add(std::uint64_t word) { value = (value ^ word) * 0x100000001b3; }
    void begin(const std::string& stage) {
        ++calls[stage];
        add(stage.size() * 256 + static_cast<unsigned char>(stage[0]));
    }
    void mask(const FragmentMask& told) {
        for (const std::uint64_t word : told.words)
            add(word);
    }
    void color(const ColorPlanes& planes, unsigned lane) {
        add(planes.r[lane] + 256u * planes.g[lane] + 65536u * planes.b[lane]);
        add(planes.a[lane]);
    }
    template <class Visit>
    void live(const probed::Batch& batch, Visit&& visit) {
        for (unsigned lane = 0; lane < batch.fragments->lanes(); ++lane)
            if (batch.fragments->live.test(lane)) visit(lane);
    }
    void shaded(const char* stage, const probed::Batch& batch) {
        begin(stage);
        live(batch, [&](unsigned lane) { color(batch.fragments->color, lane); });
    }
};

BusyPicture draw_probed(const FunctionalGpu::Config& config, Digest& digest) {
    return draw_busy_scene(
        config,
        [&](FunctionalGpu& gpu) { gpu.set_stage_probe(&digest); },
        [](FunctionalGpu& gpu) { gpu.set_stage_probe(nullptr); });
}

} // namespace

TEST_CASE("with a probe the pictures and counters are those without, for any number of threads") {
    const BusyPicture plain = draw_busy_scene({});
    Digest one, three, reference;
    CHECK(draw_probed({}, one) == plain);
    CHECK(draw_probed({.threads = 3}, three) == plain);
    CHECK(draw_probed({.threads = 2, .stages = &ReferenceStages}, reference) == plain);
    CHECK(three.value == one.value);
    CHECK(three.calls == one.calls);
    CHECK(reference.value == one.value); // Each stage, not the frame alone, is equal in both forms.
    CHECK(one.calls.size() == 15);
    CHECK(one.agreed);
}

TEST_CASE("a probe misses no primitive and no fragment") {
    Digest digest;
    const BusyPicture picture = draw_probed({}, digest);
    CHECK(digest.records == picture.counters.at("primitives_set_up"));
    CHECK(digest.covered == picture.counters.at("fragments_covered"));
    CHECK(digest.written >= picture.counters.at("fragments_written"));
    Digest small;
    CHECK(draw_probed({.tile_size = 16}, small).color == picture.color);
    CHECK(small.covered == digest.covered);
    CHECK(small.written == digest.written);
    CHECK(small.records == digest.records);
}

TEST_CASE("a probe that is taken off again is told nothing more") {
    Digest digest;
    Scene scene(32, 32);
    scene.gpu.set_stage_probe(&digest);
    scene.clear(0);
    scene.draw(PrimitiveType::Triangles,
               {{-1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {1, -1, 0, 1, 1, 1, 1, 1, 0, 0},
                {-1, 1, 0, 1, 1, 1, 1, 1, 0, 0}});
    scene.gpu.set_stage_probe(nullptr); // What waits is carried out, and told.
    CHECK(digest.records == 1);
    CHECK(digest.covered > 0);
    const std::uint64_t value = digest.value;
    draw_mixture(scene, [](int) { return PrimitiveType::Triangles; });
    scene.gpu.finish();
    CHECK(digest.value == value);
}
