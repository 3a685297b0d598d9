// Numbers that stand side by side in memory, written by one store. What is read by wider loads soon
// after it was written number by number waits until all of these stores have left the processor:
// a load takes its bytes from one store that is still under way, never from several.

#pragma once

#include <cstring>

namespace ffgpu {

// To `to` and on; together a power of two of bytes.
template <class Number, class... Numbers>
void store_at_once(Number* to, Number first, Numbers... others) {
    using All [[gnu::vector_size(sizeof(Number) * (1 + sizeof...(others)))]] = Number;
    const All all{first, others...};
    std::memcpy(to, &all, sizeof all);
}

} // namespace ffgpu
