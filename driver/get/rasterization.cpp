// Rasterization and multisampling (GL 1.5, state tables 6.11 and 6.12).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"
#include "driver/limits.h"

#include <array>

namespace ffgpu::gl {

std::span<const StateVariable> rasterization_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_POINT_SIZE, real(s.rasterization.point.size)),
        FFGPU_STATE(GL_POINT_SIZE_MIN, real(s.rasterization.point.size_min)),
        FFGPU_STATE(GL_POINT_SIZE_MAX, real(s.rasterization.point.size_max)),
        FFGPU_STATE(GL_POINT_FADE_THRESHOLD_SIZE, real(s.rasterization.point.fade_threshold)),
        FFGPU_STATE(GL_POINT_DISTANCE_ATTENUATION, real(s.rasterization.point.attenuation)),
        FFGPU_STATE(GL_POINT_SPRITE_COORD_ORIGIN, integer(s.rasterization.point.sprite_origin)),
        FFGPU_STATE(GL_LINE_WIDTH, real(s.rasterization.line.width)),
        FFGPU_STATE(GL_LINE_STIPPLE_PATTERN, integer(s.rasterization.line.stipple_pattern)),
        FFGPU_STATE(GL_LINE_STIPPLE_REPEAT, integer(s.rasterization.line.stipple_factor)),
        FFGPU_STATE(GL_CULL_FACE_MODE, integer(s.rasterization.polygon.cull_face)),
        FFGPU_STATE(GL_FRONT_FACE, integer(s.rasterization.polygon.front_face)),
        FFGPU_STATE(GL_POLYGON_MODE, integer(s.rasterization.polygon.mode)),
        FFGPU_STATE(GL_POLYGON_OFFSET_FACTOR, real(s.rasterization.polygon.offset_factor)),
        FFGPU_STATE(GL_POLYGON_OFFSET_UNITS, real(s.rasterization.polygon.offset_units)),
        FFGPU_STATE(GL_POLYGON_OFFSET_BIAS_EXT,
                    real(s.rasterization.polygon.offset_units / OffsetUnitsInRange)),
        FFGPU_STATE(GL_SAMPLE_COVERAGE_VALUE, real(s.rasterization.multisample.coverage_value)),
        FFGPU_STATE(GL_SAMPLE_COVERAGE_INVERT,
                    boolean(s.rasterization.multisample.coverage_invert)),
        FFGPU_STATE(GL_PERSPECTIVE_CORRECTION_HINT, integer(s.hint.perspective_correction)),
        FFGPU_STATE(GL_POINT_SMOOTH_HINT, integer(s.hint.point_smooth)),
        FFGPU_STATE(GL_LINE_SMOOTH_HINT, integer(s.hint.line_smooth)),
        FFGPU_STATE(GL_POLYGON_SMOOTH_HINT, integer(s.hint.polygon_smooth)),
        FFGPU_STATE(GL_FOG_HINT, integer(s.hint.fog)),
        FFGPU_STATE(GL_GENERATE_MIPMAP_HINT, integer(s.hint.generate_mipmap)),
        FFGPU_STATE(GL_TEXTURE_COMPRESSION_HINT, integer(s.hint.texture_compression)),
    };
    return Table;
}

} // namespace ffgpu::gl
