// Rectangle: pixels of the window, half open: x0 <= x < x1, y0 <= y < y1.

#pragma once

#include <algorithm>

namespace ffgpu {

struct Rectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }

    bool operator==(const Rectangle&) const = default;
};

inline Rectangle intersect(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// The least that holds both; an empty one holds nothing.
inline Rectangle unite(const Rectangle& a, const Rectangle& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

} // namespace ffgpu
