// ChunkMemory: memory for what is made piece by piece and given back as a whole. Chunks are passed
// on by a pool, so that who makes the like again and again touches the same pages: taken from the
// system anew, pages cost more than what is written to them.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace ffgpu {

// Of chunks that nobody uses. Any thread may take and give.
class ChunkPool {
public:
    static constexpr std::size_t ChunkBytes = std::size_t{64} << 10;
    using Chunk = std::unique_ptr<std::byte[]>;

    Chunk take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique_for_overwrite<std::byte[]>(ChunkBytes);
        Chunk chunk = std::move(free_.back());
        free_.pop_back();
        return chunk;
    }
    void give(std::vector<Chunk>& chunks) {
        const std::lock_guard lock(mutex_);
        for (Chunk& chunk : chunks)
            free_.push_back(std::move(chunk));
        chunks.clear();
    }

private:
    std::mutex mutex_;
    std::vector<Chunk> free_;
};

// One thread takes memory of it; any may end it.
class ChunkMemory final : public std::pmr::memory_resource {
public:
    explicit ChunkMemory(std::shared_ptr<ChunkPool> pool)
        : pool_(std::move(pool)) {}
    ~ChunkMemory() override { pool_->give(chunks_); }
    ChunkMemory(const ChunkMemory&) = delete;
    ChunkMemory& operator=(const ChunkMemory&) = delete;

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        void* at = next_;
        if (!std::align(alignment, bytes, at, left_)) at = take_chunk(bytes, alignment);
        next_ = static_cast<std::byte*>(at) + bytes;
        left_ -= bytes;
        return at;
    }
    void do_deallocate(void*, std::size_t, std::size_t) override {}
    bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }

    void* take_chunk(std::size_t bytes, std::size_t alignment) {
        left_ = std::max(ChunkPool::ChunkBytes, bytes + alignment);
        const bool is_large = left_ > ChunkPool::ChunkBytes;
        std::vector<ChunkPool::Chunk>& chunks = is_large ? large_ : chunks_;
        chunks.push_back(is_large ? std::make_unique_for_overwrite<std::byte[]>(left_)
                                  : pool_->take());
        void* at = chunks.back().get();
        return std::align(alignment, bytes, at, left_);
    }

    std::shared_ptr<ChunkPool> pool_;
    std::vector<ChunkPool::Chunk> chunks_, large_;
    std::byte* next_ = nullptr;
    std::size_t left_ = 0; // of the last chunk
};

// Of a std::pmr resource, for numbers that are all written before they are read: a vector that is
// made of so many leaves them as they are.
template <class T>
class UnsetAllocator : public std::pmr::polymorphic_allocator<T> {
public:
    using Base = std::pmr::polymorphic_allocator<T>;

    UnsetAllocator() = default;
    UnsetAllocator(std::pmr::memory_resource* resource)
        : Base(resource) {}
    template <class Other>
    UnsetAllocator(const UnsetAllocator<Other>& other)
        : Base(other.resource()) {}

    UnsetAllocator select_on_container_copy_construction() const { return {}; }
    template <class Number>
    void construct(Number* at) {
        ::new (static_cast<void*>(at)) Number;
    }
    template <class Number, class... From>
    void construct(Number* at, From&&... from) {
        ::new (static_cast<void*>(at)) Number(std::forward<From>(from)...);
    }
};

template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

} // namespace ffgpu
