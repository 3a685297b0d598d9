// Long draws in chunks: how they are cut, and that several units draw what one does.

#include "model/geometry/element_chunks.h"
#include "tests/geometry/scene.h"

#include <new>
#include <span>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

constexpr PrimitiveType FilledTypes[] = {PrimitiveType::Triangles,
                                         PrimitiveType::TriangleStrip,
                                         PrimitiveType::TriangleFan,
                                         PrimitiveType::Quads,
                                         PrimitiveType::QuadStrip};

// Random vertices, most of them in the clip volume, with colours.
void add_vertices(Scene& scene, Random& random, std::uint32_t count) {
    scene.carry_color();
    for (std::uint32_t i = 0; i < count; ++i) {
        const float w = random.between(0.5f, 2);
        scene.vertex({random.between(-1.2f, 1.2f) * w,
                      random.between(-1.2f, 1.2f) * w,
                      random.between(-1.1f, 1.1f) * w,
                      w});
        scene.vertex({random.between(0, 1), random.between(0, 1), random.between(0, 1), 1});
    }
}

void check_same(const KeptPrimitive& a, const KeptPrimitive& b) {
    REQUIRE(a.primitive.key == b.primitive.key);
    REQUIRE(a.primitive.front_facing == b.primitive.front_facing);
    for (unsigned i = 0; i < 3; ++i) {
        REQUIRE(a[i].x == b[i].x);
        REQUIRE(a[i].y == b[i].y);
        REQUIRE(a[i].depth == b[i].depth);
        REQUIRE(a[i].inverse_w == b[i].inverse_w);
        for (unsigned c = 0; c < 4; ++c)
            REQUIRE(a[i].attributes[c] == b[i].attributes[c]);
    }
}

} // namespace

TEST_CASE("chunks cover each element once, apart from what carries over") {
    for (const ChunkRule rule : {ChunkRule{},
                                 ChunkRule{.overlap = 1},
                                 ChunkRule{.overlap = 2},
                                 ChunkRule{.hub = true, .overlap = 1}})
        for (const std::uint32_t size : {12u, 24u})
            for (std::uint32_t elements = 1; elements < 100; ++elements) {
                const ElementChunks chunks(rule, elements, size);
                std::uint32_t seen = 0; // elements before it have been in a chunk
                for (std::uint32_t i = 0; i < chunks.count(); ++i) {
                    const auto [begin, end, fresh] = chunks[i];
                    REQUIRE(begin == (i == 0 ? std::uint32_t{rule.hub} : seen - rule.overlap));
                    REQUIRE(end <= begin + size);
                    REQUIRE(fresh == end - seen);
                    REQUIRE((fresh > 0 && end <= elements));
                    seen = end;
                }
                REQUIRE(seen == elements);
            }
}

TEST_CASE("units that take a long draw's chunks apart hand over what one does with all of it") {
    Random random(41);
    for (const PrimitiveType type : FilledTypes)
        for (const bool indexed : {false, true}) {
            Scene scene;
            const std::uint32_t count = 9000 + random.below(4000);
            add_vertices(scene, random, indexed ? 700 : count);
            if (indexed)
                for (std::uint32_t i = 0; i < count; ++i)
                    scene.indices.push_back(random.below(700));
            const DrawCommand command = scene.command(type);
            scene.fill_memory();
            const DrawState state = scene.state();

            GeometryUnit whole(scene.memory);
            KeepingSink expected;
            whole.draw(state, command, expected);

            GeometryUnit units[] = {GeometryUnit(scene.memory), GeometryUnit(scene.memory)};
            const std::uint32_t chunks = units[0].separate_chunks(state, command);
            REQUIRE(chunks == (indexed ? (count + 4091) / 4092 : (count + 1019) / 1020));
            std::vector<KeepingSink> sinks(chunks);
            units[0].begin_separate_chunks(state, command);
            for (std::uint32_t i = chunks; i-- > 0;) // From behind.
                units[i % 2].draw_chunk(state, command, i, sinks[i]);

            std::vector<KeptPrimitive> kept;
            for (const KeepingSink& sink : sinks)
                kept.insert(kept.end(), sink.kept.begin(), sink.kept.end());
            REQUIRE(kept.size() > 500);
            REQUIRE(kept.size() == expected.kept.size());
            for (std::size_t i = 0; i < kept.size(); ++i)
                check_same(kept[i], expected.kept[i]);

            units[0].statistics().take_over(units[1].statistics());
            auto counter = whole.statistics().counters().begin();
            for (const Counter& sum : units[0].statistics().counters()) {
                INFO(sum.name());
                CHECK(sum.value() == counter++->value());
            }
            CHECK(units[1].statistics().draws.value() == 0);
        }
}

TEST_CASE("draws whose parts count on from each other are left whole") {
    Random random(42);
    Scene scene;
    add_vertices(scene, random, 3000);
    scene.fill_memory();
    const GeometryUnit unit(scene.memory);
    const auto chunks = [&](PrimitiveType type) {
        return unit.separate_chunks(scene.state(), scene.command(type));
    };
    CHECK(chunks(PrimitiveType::Triangles) == 3);
    for (const PrimitiveType type : {PrimitiveType::Points,
                                     PrimitiveType::Lines,
                                     PrimitiveType::LineStrip,
                                     PrimitiveType::LineLoop,
                                     PrimitiveType::Polygon})
        CHECK(chunks(type) == 1);

    DrawCommand command = scene.command(PrimitiveType::Triangles);
    command.count = 1020;
    CHECK(unit.separate_chunks(scene.state(), command) == 1);
    command.count = 0;
    CHECK(unit.separate_chunks(scene.state(), command) == 1);
    command = scene.command(PrimitiveType::Triangles);
    command.vertex_address = 4; // The last vertex ends beyond memory.
    CHECK(unit.separate_chunks(scene.state(), command) == 1);

    scene.registers.primitive.back_mode = PolygonMode::Line;
    CHECK(chunks(PrimitiveType::Triangles) == 1);
}

TEST_CASE("a unit goes on as if nothing had been after a sink that threw") {
    struct ThrowingSink final : PrimitiveSink {
        void primitives(std::span<const Primitive>) override { throw std::bad_alloc(); }
    };
    Random random(43);
    Scene scene;
    add_vertices(scene, random, 3000);
    scene.fill_memory();
    DrawCommand command = scene.command(PrimitiveType::Triangles);
    GeometryUnit used(scene.memory), fresh(scene.memory);
    ThrowingSink full;
    CHECK_THROWS_AS(used.draw(scene.state(), command, full), std::bad_alloc);
    used.reset();

    command.count = 30;
    KeepingSink kept, expected;
    used.draw(scene.state(), command, kept);
    fresh.draw(scene.state(), command, expected);
    REQUIRE(!expected.kept.empty());
    REQUIRE(kept.kept.size() == expected.kept.size());
    CHECK(used.statistics().primitives_out.value() == expected.kept.size());
}
