#include "driver/math/matrix.h"

#include "driver/math/sin_cos.h"

#include <cmath>

#define GLM_FORCE_PURE // No intrinsics: GLM's SIMD forms round otherwise.
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace ffgpu::gl {
namespace {

glm::mat4 to_glm(const Mat4& matrix) {
    return glm::make_mat4(matrix.data());
}

Mat4 from_glm(const glm::mat4& matrix) {
    Mat4 result;
    const float* const elements = glm::value_ptr(matrix);
    std::copy(elements, elements + 16, result.begin());
    return result;
}

Mat4 rounded(const std::array<double, 16>& matrix) {
    Mat4 result;
    for (std::size_t i = 0; i < 16; ++i)
        result[i] = static_cast<float>(matrix[i]);
    return result;
}

template <class Matrix>
bool is_finite(const Matrix& matrix) {
    for (const float element : matrix) {
        if (!std::isfinite(element)) return false;
    }
    return true;
}

} // namespace

Mat4 multiply(const Mat4& a, const Mat4& b) {
    return from_glm(to_glm(a) * to_glm(b));
}

Mat4 transpose(const Mat4& matrix) {
    return from_glm(glm::transpose(to_glm(matrix)));
}

Mat4 inverse(const Mat4& matrix) {
    const Mat4 result = from_glm(glm::mat4(glm::inverse(glm::dmat4(to_glm(matrix)))));
    return is_finite(result) ? result : Identity4;
}

std::array<float, 9> normal_matrix(const Mat4& matrix) {
    // Column-major inverse = row-major inverse transpose.
    const glm::mat3 inverted(glm::inverse(glm::dmat3(to_glm(matrix))));
    std::array<float, 9> result;
    const float* const elements = glm::value_ptr(inverted);
    std::copy(elements, elements + 9, result.begin());
    if (!is_finite(result)) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
    return result;
}

Vec4 transform(const Mat4& m, const Vec4& v) {
    Vec4 result;
    for (std::size_t row = 0; row < 4; ++row)
        result[row] = m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * v[3];
    return result;
}

Vec4 transform_plane(const Vec4& p, const Mat4& m) {
    Vec4 result;
    for (std::size_t column = 0; column < 4; ++column) {
        const float* const c = &m[4 * column];
        result[column] = p[0] * c[0] + p[1] * c[1] + p[2] * c[2] + p[3] * c[3];
    }
    return result;
}

Mat4 translation(double x, double y, double z) {
    return rounded({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1});
}

Mat4 scaling(double x, double y, double z) {
    return rounded({x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1});
}

namespace {

// Programs that never wrap a counter pass angles of 10^9 degrees. Drivers turn those into radians
// in binary32, whose coarse steps then decide what is seen: do as they do. Below, the steps are
// smaller than a pixel, and the exact angle is kept.
double as_seen(double degrees) {
    constexpr double RadiansPerDegree = 3.14159265358979323846 / 180;
    constexpr double Coarse = 65536;
    constexpr double Sensible = 1e30; // within binary32
    if (!(std::abs(degrees) > Coarse && std::abs(degrees) < Sensible)) return degrees;
    return static_cast<double>(static_cast<float>(degrees * RadiansPerDegree)) / RadiansPerDegree;
}

} // namespace

Mat4 rotation(double degrees, double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length)) return Identity4;
    x /= length;
    y /= length;
    z /= length;
    const auto [s, c] = sin_cos_degrees(as_seen(degrees));
    const double d = 1 - c;
    return rounded({x * x * d + c,
                    y * x * d + z * s,
                    z * x * d - y * s,
                    0,
                    x * y * d - z * s,
                    y * y * d + c,
                    z * y * d + x * s,
                    0,
                    x * z * d + y * s,
                    y * z * d - x * s,
                    z * z * d + c,
                    0,
                    0,
                    0,
                    0,
                    1});
}

Mat4 frustum(double left, double right, double bottom, double top, double near, double far) {
    const double width = right - left, height = top - bottom, depth = far - near;
    std::array<double, 16> m{};
    m[0] = 2 * near / width;
    m[5] = 2 * near / height;
    m[8] = (right + left) / width;
    m[9] = (top + bottom) / height;
    m[10] = -(far + near) / depth;
    m[11] = -1;
    m[14] = -2 * far * near / depth;
    return rounded(m);
}

Mat4 ortho(double left, double right, double bottom, double top, double near, double far) {
    const double width = right - left, height = top - bottom, depth = far - near;
    std::array<double, 16> m{};
    m[0] = 2 / width;
    m[5] = 2 / height;
    m[10] = -2 / depth;
    m[12] = -(right + left) / width;
    m[13] = -(top + bottom) / height;
    m[14] = -(far + near) / depth;
    m[15] = 1;
    return rounded(m);
}

} // namespace ffgpu::gl
