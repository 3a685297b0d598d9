// Vertex fetch: formats, indices, the edges of memory; reuse and chunks that nobody can see.

#include "tests/geometry/scene.h"

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// Points along x at -1 + (i + 1) / 512 * 2, so that x in the window is (i + 1) / 2 pixels.
Scene points(unsigned count) {
    Scene scene;
    for (unsigned i = 0; i < count; ++i)
        scene.vertex({-1 + static_cast<float>(i + 1) / 256, 0, 0, 1});
    return scene;
}

std::int64_t double_area(const KeptPrimitive& t) {
    return std::int64_t{t[1].x - t[0].x} * (t[2].y - t[0].y) -
           std::int64_t{t[2].x - t[0].x} * (t[1].y - t[0].y);
}

int number_of(const KeptPrimitive& primitive) {
    return primitive[0].x / 128 - 1;
}

std::vector<int> numbers_of(const std::vector<KeptPrimitive>& primitives) {
    std::vector<int> numbers;
    numbers.reserve(primitives.size());
    for (const KeptPrimitive& primitive : primitives)
        numbers.push_back(number_of(primitive));
    return numbers;
}

TEST_CASE("without indices the vertices from first on are drawn") {
    Scene scene = points(8);
    DrawCommand command = scene.command(PrimitiveType::Points);
    command.first = 3;
    command.count = 4;
    CHECK(numbers_of(scene.draw(command)) == std::vector<int>{3, 4, 5, 6});
    CHECK(scene.work.vertices == std::vector<std::uint32_t>{3, 4, 5, 6});
}

TEST_CASE("an index beyond the last vertex reads the last vertex") {
    Scene scene = points(8);
    scene.indices = {7, 8, 0xffffffff, 2};
    CHECK(numbers_of(scene.draw(PrimitiveType::Points)) == std::vector<int>{7, 7, 7, 2});
    scene.indices.clear();
    DrawCommand command = scene.command(PrimitiveType::Points);
    command.first = 0xfffffffe;
    command.count = 3;
    CHECK(numbers_of(scene.draw(command)) == std::vector<int>{7, 7, 7});
}

TEST_CASE("indices of 16 bits are read as such") {
    Scene scene = points(8);
    scene.indices = {0x00050001, 0x00020007};
    DrawCommand command = scene.command(PrimitiveType::Points);
    command.index_type = IndexType::U16;
    command.count = 4;
    CHECK(numbers_of(scene.draw(command)) == std::vector<int>{1, 5, 7, 2});
    CHECK(scene.work.index_bytes == 2);
}

TEST_CASE("a draw that reaches one byte beyond memory is dropped, one that just fits is not") {
    Scene scene = points(8);
    scene.indices = {0, 1};
    scene.fill_memory();
    const auto drawn = [&](DrawCommand command) {
        GeometryUnit unit(scene.memory);
        KeepingSink sink;
        unit.draw(scene.state(), command, sink);
        const auto& statistics = unit.statistics();
        CHECK(statistics.draws.value() + statistics.draws_dropped.value() == 1);
        if (statistics.draws_dropped.value() != 0) CHECK(sink.kept.empty());
        return statistics.draws.value() == 1;
    };
    DrawCommand command = scene.command(PrimitiveType::Points);
    CHECK(drawn(command));
    command.index_address += 1;
    CHECK_FALSE(drawn(command));
    command.index_address = 0xffffffff;
    CHECK_FALSE(drawn(command));

    command = scene.command(PrimitiveType::Points);
    command.index_type = IndexType::None;
    command.vertex_address = 8; // Two indices' worth of room is left behind the vertices.
    CHECK(drawn(command));
    command.vertex_address = 9;
    CHECK_FALSE(drawn(command));
    command.vertex_address = 0;
    command.vertex_count = 0;
    CHECK_FALSE(drawn(command));
    command.vertex_count = 0xffffffff;
    CHECK_FALSE(drawn(command));
}

TEST_CASE(
    "attributes that the vertices lack come from the current ones, components are completed") {
    Scene scene;
    scene.registers.vertex_format.elements[0].components = 2;
    scene.registers.vertex_format.stride = 2;
    scene.carry(Attribute::Color, 3);
    scene.layout.secondary = 4;
    scene.layout.count = 7;
    scene.registers.current.values[static_cast<unsigned>(Attribute::SecondaryColor)] = {
        0.25f, 0.5f, 0.75f, 1};
    scene.registers.viewport.far_depth = 1;
    scene.vertex({0, 0, 0.5f, 0.125f, 1});
    const auto kept = scene.draw(PrimitiveType::Points);
    REQUIRE(kept.size() == 1);
    const auto& attributes = kept[0][0].attributes;
    CHECK(kept[0][0].x == 128 * 256);
    CHECK(kept[0][0].depth == 0.5f);
    CHECK(kept[0][0].inverse_w == 1);
    CHECK(std::vector<float>(attributes.begin(), attributes.begin() + 7) ==
          std::vector<float>{0.5f, 0.125f, 1, 1, 0.25f, 0.5f, 0.75f});
}

TEST_CASE("a vertex whose index comes again is shaded once") {
    Scene scene = points(100);
    for (std::uint32_t i = 0; i < 600; ++i)
        scene.indices.push_back(i * 7 % 100);
    scene.fill_memory();
    GeometryUnit unit(scene.memory);
    KeepingSink sink;
    unit.draw(scene.state(), scene.command(PrimitiveType::Points), sink);
    CHECK(unit.statistics().vertices_fetched.value() == 600);
    CHECK(unit.statistics().vertices_shaded.value() == 100);
}

// Metamorphic: the same elements with indices and without, in a draw longer than a chunk.
TEST_CASE("indices, reuse and chunks change nothing but the work") {
    Random random(4);
    constexpr std::array Types{PrimitiveType::Points,
                               PrimitiveType::Lines,
                               PrimitiveType::LineLoop,
                               PrimitiveType::LineStrip,
                               PrimitiveType::Triangles,
                               PrimitiveType::TriangleStrip,
                               PrimitiveType::TriangleFan,
                               PrimitiveType::Quads,
                               PrimitiveType::QuadStrip,
                               PrimitiveType::Polygon};
    for (const PrimitiveType type : Types) {
        Scene indexed;
        indexed.carry_color();
        for (unsigned i = 0; i < 700; ++i) {
            for (unsigned c = 0; c < 3; ++c)
                indexed.words.push_back(random.between(-1.1f, 1.1f));
            indexed.words.push_back(1);
            for (unsigned c = 0; c < 4; ++c)
                indexed.words.push_back(random.between(0, 1));
        }
        Scene plain = indexed;
        plain.words.clear();
        for (unsigned i = 0; i < 9001; ++i) {
            const std::uint32_t index = random.below(700);
            indexed.indices.push_back(index);
            plain.words.insert(plain.words.end(),
                               indexed.words.begin() + index * 8,
                               indexed.words.begin() + index * 8 + 8);
        }
        const auto a = indexed.draw(type), b = plain.draw(type);
        INFO("type " << static_cast<int>(type));
        REQUIRE(a.size() == b.size());
        REQUIRE(indexed.work.vertices == indexed.indices);
        for (std::size_t i = 0; i < a.size(); ++i) {
            REQUIRE(a[i].primitive.key == b[i].primitive.key);
            REQUIRE(a[i].primitive.front_facing == b[i].primitive.front_facing);
            if (a[i].primitive.shape == PrimitiveShape::Triangle)
                REQUIRE((double_area(a[i]) > 0) == a[i].primitive.front_facing);
            for (unsigned v = 0; v < 3; ++v) {
                REQUIRE(a[i][v].x == b[i][v].x);
                REQUIRE(a[i][v].y == b[i][v].y);
                if (a[i].primitive.vertices[v])
                    REQUIRE(std::equal(a[i][v].attributes.begin(),
                                       a[i][v].attributes.begin() + 4,
                                       b[i][v].attributes.begin()));
            }
        }
    }
}

} // namespace
} // namespace ffgpu
