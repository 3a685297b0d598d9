// Where two threads write side by side: what stands in one cache line moves between their
// processors at each write, whoever it belongs to.

#pragma once

#include <cstddef>

namespace ffgpu {

// Alignment of what one thread writes while another works beside it: two lines of 64 bytes, which
// processors fetch in pairs.
inline constexpr std::size_t CacheLinePair = 128;

} // namespace ffgpu
