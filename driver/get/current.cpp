// Current values and raster position (GL 1.5, state table 6.5).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"

#include <array>

namespace ffgpu::gl {
namespace {

StateValue normal(const Vec4& vector) {
    return values::normalized(vector[0], vector[1], vector[2]);
}

} // namespace

std::span<const StateVariable> current_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_CURRENT_COLOR, normalized(s.current.of(Attribute::Color))),
        FFGPU_STATE(GL_CURRENT_SECONDARY_COLOR,
                    normalized(s.current.of(Attribute::SecondaryColor))),
        FFGPU_STATE(GL_CURRENT_INDEX, real(s.current.color_index)),
        FFGPU_STATE(GL_CURRENT_TEXTURE_COORDS,
                    real(s.current.of(tex_coord(s.texture.active_unit)))),
        FFGPU_STATE(GL_CURRENT_NORMAL, normal(s.current.of(Attribute::Normal))),
        FFGPU_STATE(GL_CURRENT_FOG_COORD, real(s.current.of(Attribute::FogCoordinate)[0])),
        FFGPU_STATE(GL_EDGE_FLAG, boolean(s.current.of(Attribute::EdgeFlag)[0] != 0)),
        FFGPU_STATE(GL_CURRENT_RASTER_POSITION, real(s.current.raster.position)),
        FFGPU_STATE(GL_CURRENT_RASTER_POSITION_VALID, boolean(s.current.raster.valid)),
        FFGPU_STATE(GL_CURRENT_RASTER_DISTANCE, real(s.current.raster.distance)),
        FFGPU_STATE(GL_CURRENT_RASTER_COLOR, normalized(s.current.raster.color)),
        FFGPU_STATE(GL_CURRENT_RASTER_SECONDARY_COLOR,
                    normalized(s.current.raster.secondary_color)),
        FFGPU_STATE(GL_CURRENT_RASTER_INDEX, real(s.current.raster.color_index)),
        FFGPU_STATE(GL_CURRENT_RASTER_TEXTURE_COORDS,
                    real(s.current.raster.tex_coords[s.texture.active_unit])),
    };
    return Table;
}

} // namespace ffgpu::gl
