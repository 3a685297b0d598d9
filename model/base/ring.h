// Ring: a queue in one piece of memory. It grows where it has to and keeps what it once had, so
// that a queue that is used all the time allocates nothing.

#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace ffgpu {

template <class T>
class Ring {
public:
    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }

    // The i-th from the front.
    T& operator[](std::size_t i) { return items_[place(i)]; }
    const T& operator[](std::size_t i) const { return items_[place(i)]; }
    T& front() { return items_[first_]; }
    const T& front() const { return items_[first_]; }
    T& back() { return items_[place(count_ - 1)]; }
    const T& back() const { return items_[place(count_ - 1)]; }

    void push_back(T item) { append() = std::move(item); }
    // The place behind the last, for its owner to fill: what is in it is of no meaning.
    T& append() {
        if (count_ == mask_ + 1) grow();
        return items_[place(count_++)];
    }
    void pop_front() {
        if constexpr (!std::is_trivially_destructible_v<T>) items_[first_] = T{};
        first_ = place(1);
        --count_;
    }
    void clear() {
        while (!empty())
            pop_front();
    }

private:
    // The size is a power of two, or nothing.
    std::size_t place(std::size_t i) const { return (first_ + i) & mask_; }

    void grow() {
        std::vector<T> more(items_.empty() ? 8 : 2 * items_.size());
        for (std::size_t i = 0; i < count_; ++i)
            more[i] = std::move((*this)[i]);
        items_ = std::move(more);
        mask_ = items_.size() - 1;
        first_ = 0;
    }

    std::vector<T> items_;
    std::size_t mask_ = ~std::size_t{0}; // its size less one: of a vector that is a division
    std::size_t first_ = 0, count_ = 0;
};

} // namespace ffgpu
