// The memory of a traced program: what a trace does not hold of an array reads as zeroes.

#include "driver/objects/shared_objects.h"
#include "driver/trace/player/client_memory.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <array>
#include <memory>

#include <catch2/catch.hpp>

using namespace ffgpu;

TEST_CASE("an array that is shorter than a draw reaches is zeroes from its end on") {
    FunctionalGpu gpu({.memory_bytes = std::uint64_t{32} << 20});
    const gl::Context context(gpu, std::make_shared<gl::SharedObjects>(gpu));
    const std::array<float, 6> values{1, 2, 3, 4, 5, 6};
    trace::Blob blob;
    blob.append(reinterpret_cast<const std::byte*>(values.data()), sizeof values);
    gl::VertexArray array{.enabled = true, .size = 3, .pointer = blob.data()};
    trace::ClientMemory memory;
    memory.keep_array(context, &array, blob);
    CHECK(memory.vertices_available(array) == 2);

    REQUIRE(memory.extend(array, 3));
    REQUIRE(memory.vertices_available(array) >= 3);
    REQUIRE(memory.extend(array, 1000));
    REQUIRE(memory.vertices_available(array) >= 1000);
    const auto* const at = static_cast<const float*>(array.pointer);
    CHECK(std::equal(values.begin(), values.end(), at));
    CHECK(std::all_of(at + values.size(), at + 3000, [](float value) { return value == 0; }));
    CHECK_FALSE(memory.extend(array, std::uint64_t{1} << 40));
}
