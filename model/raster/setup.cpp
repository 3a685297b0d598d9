#include "model/raster/setup.h"

#include "model/raster/shape_setup.h"

#include <algorithm>

namespace ffgpu {
namespace {

Rectangle surface_rectangle(const Surface& surface) {
    return {0, 0, surface.width, surface.height};
}

// Where there is no target, nothing can be drawn.
Rectangle clip_rectangle(const Registers& registers) {
    const Scissor& scissor = registers.scissor;
    Rectangle clip{scissor.x, scissor.y, scissor.x + scissor.width, scissor.y + scissor.height};
    bool has_target = false;
    Targets::for_each(registers.targets, [&](const Surface& surface) {
        if (surface.format == Format::None) return;
        clip = intersect(clip, surface_rectangle(surface));
        has_target = true;
    });
    return has_target ? clip : Rectangle{};
}

} // namespace

SetupContext compile_setup(const DrawState& state) {
    const Registers& registers = state.regs();
    const bool depth16 = registers.targets.depth.format == Format::Depth16;
    PrimitiveSetup primitive = registers.primitive;
    if (state.multisample)
        primitive.point_smooth = primitive.line_smooth = primitive.polygon_smooth = false;
    return {.primitive = primitive,
            .layout = state.layout,
            .clip = clip_rectangle(registers),
            .multisample = state.multisample,
            .depth_scale = depth16 ? 0xffffu : 0xffffffu};
}

bool set_up(const SetupContext& context,
            const Primitive& primitive,
            SetupRecord& at,
            bool all_planes) {
    if (context.clip.empty()) return false;
    at.coverage = CoverageKind::Centre;
    at.stipple = StippleKind::None;
    at.front_facing = primitive.front_facing;
    at.key = primitive.key;
    at.covers_nothing = false;
    switch (primitive.shape) {
    case PrimitiveShape::Triangle:
        return set_up_triangle(context, primitive, at, all_planes);
    case PrimitiveShape::Line:
        return set_up_line(context, primitive, at);
    case PrimitiveShape::Point:
        return set_up_point(context, primitive, at);
    }
    return false;
}

} // namespace ffgpu
