// What a comparison means, for alpha, stencil and depth tests and for depth textures:
// value (compare) reference.

#pragma once

#include "model/device/registers/texture.h"

#include <cstdint>

namespace ffgpu {

constexpr bool compare(Compare function, std::uint32_t value, std::uint32_t reference) {
    switch (function) {
    case Compare::Never:
        return false;
    case Compare::Less:
        return value < reference;
    case Compare::Equal:
        return value == reference;
    case Compare::Lequal:
        return value <= reference;
    case Compare::Greater:
        return value > reference;
    case Compare::Notequal:
        return value != reference;
    case Compare::Gequal:
        return value >= reference;
    case Compare::Always:
        return true;
    }
    return true;
}

} // namespace ffgpu
