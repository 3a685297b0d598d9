#include "tests/gallery/harness/heights.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {

techniques::Field hills(int size) {
    techniques::Field field(size, size);
    for (int i = 0; i < size * size; ++i) {
        const double u = 2 * std::numbers::pi * (i % size + 0.5) / size;
        const double v = 2 * std::numbers::pi * (static_cast<int>(i / size) + 0.5) / size;
        const double waves = 0.25 * std::sin(3 * u + std::cos(2 * v)) + 0.15 * std::cos(4 * v - u);
        field.at(i % size, i / size) = 0.5 + waves + 0.1 * std::sin(5 * u) * std::sin(6 * v);
    }
    return field;
}

} // namespace ffgpu::gallery
