// Vectors of lanes: three or four numbers of LaneCount vertices each.

namespace ffgpu::FFGPU_LANES {

using Floats3 = std::array<Floats, 3>;
using Floats4 = std::array<Floats, 4>;

inline Floats3 load3(const Planes3& planes, unsigned lane) {
    return {load(planes[0].at(lane)), load(planes[1].at(lane)), load(planes[2].at(lane))};
}
inline Floats4 load4(const Planes4& planes, unsigned lane) {
    return {load(planes[0].at(lane)),
            load(planes[1].at(lane)),
            load(planes[2].at(lane)),
            load(planes[3].at(lane))};
}
template <std::size_t Size>
void store_all(const std::array<Floats, Size>& values,
               std::array<Plane, Size>& planes,
               unsigned lane) {
    for (unsigned i = 0; i < Size; ++i)
        store(values[i], planes[i].at(lane));
}
inline Floats3 splat3(const std::array<float, 3>& v) {
    return {splat(v[0]), splat(v[1]), splat(v[2])};
}

inline Floats3 operator+(const Floats3& a, const Floats3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Floats3 operator-(const Floats3& a, const Floats3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Floats3 operator*(const Floats3& a, Floats factor) {
    return {a[0] * factor, a[1] * factor, a[2] * factor};
}

// The order of the sum is part of the arithmetic: (x + y) + z, and (x + y) + (z + w).
inline Floats dot(const Floats3& a, const Floats3& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
inline Floats dot(const Vec4& a, const Floats4& b) {
    return (splat(a[0]) * b[0] + splat(a[1]) * b[1]) + (splat(a[2]) * b[2] + splat(a[3]) * b[3]);
}

// m is column-major.
inline Floats transform_row(const Mat4& m, unsigned row, const Floats4& v) {
    return dot(Vec4{m[row], m[4 + row], m[8 + row], m[12 + row]}, v);
}

// The zero vector stays zero; so does one whose squared length is NaN.
inline Floats3 normalize(const Floats3& v) {
    const Floats square = dot(v, v);
    const Floats factor = zero_unless(square > splat(0.0f), splat(1.0f) / square_root(square));
    return v * factor;
}

// NaN becomes 0.
inline Floats clamp_color(Floats x) {
    return minimum(maximum(x, splat(0.0f)), splat(1.0f));
}

} // namespace ffgpu::FFGPU_LANES
