// The areas over lanes of pixels: FFGPU_LANES has Doubles and its operations, and `AreaLanes`, how
// many pixels a Doubles holds. Plain numbers make it the specification, vectors what runs.

namespace ffgpu::FFGPU_LANES {

inline Doubles hold(Doubles value) {
    return minimum(maximum(value, splat(0)), splat(1));
}

// How far a height lies above the pixel's upper side.
inline Doubles over(Doubles height) {
    return maximum(height - splat(1), splat(0));
}

// What the edge has below it inside the pixels at (x, y).
inline Doubles area_below(const AreaEdge& edge, Doubles x, double y) {
    const Doubles slope = splat(edge.slope), level = splat(edge.y0 - y);
    const Doubles begin = splat(edge.x0) - x;
    const Doubles left = hold(begin), right = hold(splat(edge.x1) - x);
    const Doubles first = level + (left - begin) * slope;
    const Doubles last = level + (right - begin) * slope;
    const Doubles first_held = hold(first), last_held = hold(last);
    const Doubles sum = first_held + last_held;
    const Doubles rise = last - first;
    // The integral of the held height over the height, by the rise: the mean held height.
    const Doubles integral =
        (last_held - first_held) * sum * splat(0.5) + (over(last) - over(first));
    const Doubles mean =
        where_less(absolute(rise), splat(LevelEdge), sum * splat(0.5), integral / rise);
    return (left - right) * mean;
}

inline void areas_of_row(const AreaPolygon& polygon, int x, int y, RowAreas& areas) {
    for (unsigned lane = 0; lane < AreaRow; lane += AreaLanes) {
        const Doubles pixels = pixels_from(x + static_cast<int>(lane));
        Doubles sum = splat(0);
        for (unsigned e = 0; e < polygon.count; ++e)
            sum = sum + area_below(polygon.edges[e], pixels, y);
        store(sum, areas.data() + lane);
    }
}

} // namespace ffgpu::FFGPU_LANES
