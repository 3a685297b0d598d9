// Memory that is made piece by piece, and its chunks' way from one owner to the next.

#include "model/base/chunk_memory.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

bool is_aligned(const void* at, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(at) % alignment == 0;
}

TEST_CASE("Pieces lie apart, each as it asks, also where a chunk ends") {
    ChunkMemory memory(std::make_shared<ChunkPool>());
    std::vector<std::pair<unsigned char*, std::size_t>> pieces;
    for (std::size_t i = 1; i < 3000; ++i) {
        const std::size_t bytes = 1 + i * 37 % 300, alignment = std::size_t{1} << i % 7;
        auto* const piece = static_cast<unsigned char*>(memory.allocate(bytes, alignment));
        REQUIRE(is_aligned(piece, alignment));
        std::memset(piece, static_cast<int>(i % 251), bytes);
        pieces.emplace_back(piece, bytes);
    }
    std::size_t changed = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t byte = 0; byte < pieces[i].second; ++byte)
            changed += pieces[i].first[byte] != (i + 1) % 251;
    CHECK(changed == 0);
}

TEST_CASE("Chunks that one gives back another takes; what is larger than a chunk is not kept") {
    const auto pool = std::make_shared<ChunkPool>();
    std::set<void*> before, after;
    const auto fill = [&](std::set<void*>& pieces) {
        ChunkMemory memory(pool);
        for (int i = 0; i < 5; ++i)
            pieces.insert(memory.allocate(ChunkPool::ChunkBytes - 1, 1));
        auto* const large = static_cast<std::byte*>(memory.allocate(3 * ChunkPool::ChunkBytes, 64));
        REQUIRE(is_aligned(large, 64));
        std::memset(large, 1, 3 * ChunkPool::ChunkBytes);
    };
    fill(before);
    fill(after);
    CHECK(before.size() == 5);
    CHECK(before == after);
}

TEST_CASE("A vector of unset numbers keeps those that it is given") {
    ChunkMemory memory(std::make_shared<ChunkPool>());
    UnsetVector<std::uint32_t> numbers(&memory);
    for (std::uint32_t i = 0; i < 1000; ++i)
        numbers.push_back(i);
    numbers.resize(2000);
    const UnsetVector<std::uint32_t> copy = numbers;
    CHECK(copy.get_allocator().resource() == std::pmr::get_default_resource());
    std::uint32_t wrong = 0;
    for (std::uint32_t i = 0; i < 1000; ++i)
        wrong += numbers[i] != i || copy[i] != i;
    CHECK(wrong == 0);
}

} // namespace
} // namespace ffgpu
