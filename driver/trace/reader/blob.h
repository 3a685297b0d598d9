// Blob: bytes that a traced program handed to a call. Aligned as malloc aligns, so that they can
// be read as any type; the memory is reused from call to call, and whoever needs it longer swaps
// it for a blob of his own.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <utility>

namespace ffgpu::trace {

class Blob {
public:
    void clear() { size_ = 0; }

    void append(const std::byte* bytes, std::size_t count) {
        reserve(size_ + count);
        std::memcpy(data_.get() + size_, bytes, count);
        size_ += count;
    }

    // Appends zeroes up to `size`.
    void pad(std::size_t size) {
        if (size <= size_) return;
        reserve(size);
        std::memset(data_.get() + size_, 0, size - size_);
        size_ = size;
    }

    std::byte* data() { return data_.get(); }
    const std::byte* data() const { return data_.get(); }
    std::size_t size() const { return size_; }
    std::span<const std::byte> bytes() const { return {data_.get(), size_}; }

    void swap(Blob& other) {
        data_.swap(other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

private:
    struct Free {
        void operator()(std::byte* bytes) const { std::free(bytes); }
    };

    void reserve(std::size_t size) {
        if (size <= capacity_) return;
        const std::size_t capacity = std::max({size, 2 * capacity_, std::size_t{64}});
        auto* moved = static_cast<std::byte*>(std::realloc(data_.get(), capacity));
        if (!moved) throw std::bad_alloc();
        static_cast<void>(data_.release()); // realloc has taken it.
        data_.reset(moved);
        capacity_ = capacity;
    }

    std::unique_ptr<std::byte, Free> data_;
    std::size_t size_ = 0, capacity_ = 0;
};

} // namespace ffgpu::trace
