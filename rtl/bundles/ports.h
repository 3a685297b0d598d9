// Ports of Verilated modules, of any width, from and to Bits.

#pragma once

#include "rtl/bundles/fields.h"

#include <verilated.h>

namespace ffgpu::rtl {

template <class Port>
requires std::is_integral_v<Port>
void drive(Port& port, const Bits& bits) {
    port = static_cast<Port>(take(bits, 0, bits.count));
}
template <std::size_t Words>
void drive(VlWide<Words>& port, const Bits& bits) {
    for (unsigned i = 0; i < Words; ++i)
        port[i] = bits.words[i];
}

template <class Port>
requires std::is_integral_v<Port> Bits sample(const Port& port, unsigned count) {
    Bits bits{.count = count};
    put(bits, 0, count, port);
    return bits;
}
template <std::size_t Words>
Bits sample(const VlWide<Words>& port, unsigned count) {
    Bits bits{.count = count};
    for (unsigned i = 0; i < Words; ++i)
        bits.words[i] = port[i];
    return bits;
}

// Whether a port is as wide as its struct, to the word.
template <class Port>
constexpr unsigned port_words(const Port&) {
    return (sizeof(Port) + 3) / 4;
}

} // namespace ffgpu::rtl
