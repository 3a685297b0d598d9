// Coordinate transformations (GL 1.5, 2.11 and 2.12; state tables 6.7): matrix stacks, viewport,
// user clip planes, treatment of normals.

#pragma once

#include "driver/gl_types.h"
#include "model/device/registers/geometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

constexpr unsigned ModelViewStackDepth = 32;
constexpr unsigned ProjectionStackDepth = 32;
constexpr unsigned TextureStackDepth = 10;

// A stack of 4x4 matrices, column-major as GL's. It is never empty.
class MatrixStack {
public:
    explicit MatrixStack(unsigned max_depth = TextureStackDepth)
        : max_depth_(max_depth) {}

    const Mat4& top() const { return matrices_.back(); }
    Mat4& top() { return matrices_.back(); }
    unsigned depth() const { return static_cast<unsigned>(matrices_.size()); }

    // False: the stack is full, or holds its last matrix; nothing changes then.
    bool push() {
        if (depth() == max_depth_) return false;
        matrices_.emplace_back(top());
        return true;
    }
    bool pop() {
        if (depth() == 1) return false;
        matrices_.pop_back();
        return true;
    }

private:
    std::vector<Mat4> matrices_{Identity4};
    unsigned max_depth_;
};

// In no attribute group: glPushAttrib leaves the stacks alone.
struct MatrixState {
    MatrixStack model_view{ModelViewStackDepth};
    MatrixStack projection{ProjectionStackDepth};
    std::array<MatrixStack, TextureUnits> texture; // of each unit
};

struct ViewportState { // GL_VIEWPORT_BIT
    GLint x = 0, y = 0;
    GLsizei width = 0, height = 0; // of the first drawable
    double near_depth = 0, far_depth = 1;
};

struct TransformGroup { // GL_TRANSFORM_BIT
    GLenum matrix_mode = GL_MODELVIEW;
    std::array<bool, ClipPlanes> clip_plane_enable{};
    std::array<Vec4, ClipPlanes> clip_planes{}; // in eye coordinates
    bool normalize = false;
    bool rescale_normal = false;
    bool depth_clamp = false; // ARB_depth_clamp
};

struct TransformState {
    MatrixState matrices;
    ViewportState viewport;
    TransformGroup group;
};

} // namespace ffgpu::gl
