// Lighting and fog (GL 1.5, state tables 6.8 and 6.9).

#include "driver/context/context.h"
#include "driver/get/state_variable.h"

#include <array>

namespace ffgpu::gl {

std::span<const StateVariable> lighting_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_SHADE_MODEL, integer(s.lighting.shade_model)),
        FFGPU_STATE(GL_COLOR_MATERIAL_FACE, integer(s.lighting.color_material.face)),
        FFGPU_STATE(GL_COLOR_MATERIAL_PARAMETER, integer(s.lighting.color_material.mode)),
        FFGPU_STATE(GL_LIGHT_MODEL_AMBIENT, normalized(s.lighting.model.ambient)),
        FFGPU_STATE(GL_LIGHT_MODEL_LOCAL_VIEWER, boolean(s.lighting.model.local_viewer)),
        FFGPU_STATE(GL_LIGHT_MODEL_TWO_SIDE, boolean(s.lighting.model.two_side)),
        FFGPU_STATE(GL_LIGHT_MODEL_COLOR_CONTROL, integer(s.lighting.model.color_control)),
        FFGPU_STATE(GL_FOG_COLOR, normalized(s.fragment.fog.color)),
        FFGPU_STATE(GL_FOG_INDEX, real(s.fragment.fog.index)),
        FFGPU_STATE(GL_FOG_DENSITY, real(s.fragment.fog.density)),
        FFGPU_STATE(GL_FOG_START, real(s.fragment.fog.start)),
        FFGPU_STATE(GL_FOG_END, real(s.fragment.fog.end)),
        FFGPU_STATE(GL_FOG_MODE, integer(s.fragment.fog.mode)),
        FFGPU_STATE(GL_FOG_COORD_SRC, integer(s.fragment.fog.coordinate_source)),
        FFGPU_STATE(GL_FOG_DISTANCE_MODE_NV, integer(s.fragment.fog.distance_mode)),
    };
    return Table;
}

} // namespace ffgpu::gl
