// 4x4 matrices of binary32, column-major as OpenGL's. Products and inverses are GLM's plain C++
// forms: the same bits on every machine (docs/arithmetic/driver.md).

#pragma once

#include "model/device/registers/geometry.h"

#include <array>

namespace ffgpu::gl {

Mat4 multiply(const Mat4& a, const Mat4& b);
Mat4 transpose(const Mat4& matrix);

// Worked out in binary64. Of a singular matrix, or where the result is not finite: the identity.
Mat4 inverse(const Mat4& matrix);

// The inverse transpose of the upper left 3x3, row-major, in the same manner.
std::array<float, 9> normal_matrix(const Mat4& matrix);

Vec4 transform(const Mat4& matrix, const Vec4& vector);

// A plane is a row vector: plane * matrix. GL takes planes to eye coordinates by the inverse of the
// model-view matrix (GL 1.5, 2.12 and 2.11.4).
Vec4 transform_plane(const Vec4& plane, const Mat4& matrix);

Mat4 translation(double x, double y, double z);
Mat4 scaling(double x, double y, double z);
Mat4 rotation(double degrees, double x, double y, double z); // a zero axis: the identity
Mat4 frustum(double left, double right, double bottom, double top, double near, double far);
Mat4 ortho(double left, double right, double bottom, double top, double near, double far);

} // namespace ffgpu::gl
