#include "driver/memory_allocator.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu::gl {

MemoryAllocator::MemoryAllocator(std::uint64_t begin, std::uint64_t end) {
    check(begin % Alignment == 0 && begin <= end, "allocator range must be aligned");
    if (begin < end) free_.emplace(begin, end);
}

std::optional<DeviceAddress> MemoryAllocator::allocate(std::uint64_t bytes) {
    if (bytes > std::uint64_t{1} << 40) return std::nullopt;
    const std::uint64_t size =
        (std::max<std::uint64_t>(bytes, 1) + Alignment - 1) & ~(Alignment - 1);
    const auto fits = [&](const auto& range) { return range.second - range.first >= size; };
    const auto range = std::find_if(free_.begin(), free_.end(), fits);
    if (range == free_.end()) return std::nullopt;

    const auto [begin, end] = *range;
    free_.erase(range);
    if (begin + size < end) free_.emplace(begin + size, end);
    used_.emplace(begin, begin + size);
    bytes_in_use_ += size;
    return static_cast<DeviceAddress>(begin);
}

void MemoryAllocator::release(DeviceAddress address) {
    const auto used = used_.find(address);
    check(used != used_.end(), "release of a range that was not allocated");
    auto [begin, end] = *used;
    used_.erase(used);
    bytes_in_use_ -= end - begin;

    const auto after = free_.find(end);
    if (after != free_.end()) {
        end = after->second;
        free_.erase(after);
    }
    const auto next = free_.lower_bound(begin);
    if (next != free_.begin() && std::prev(next)->second == begin) {
        std::prev(next)->second = end;
    } else {
        free_.emplace(begin, end);
    }
}

} // namespace ffgpu::gl
