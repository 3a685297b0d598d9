#include "model/work/target_clear.h"

#include "model/memory/clear.h"

namespace ffgpu::work {

Rectangle cleared_rectangle(const Registers& state) {
    const Scissor& scissor = state.scissor;
    Rectangle rectangle{
        scissor.x, scissor.y, scissor.x + scissor.width, scissor.y + scissor.height};
    Targets::for_each(state.targets, [&rectangle](const Surface& target) {
        if (target.format != Format::None)
            rectangle = intersect(rectangle, {0, 0, target.width, target.height});
    });
    return rectangle;
}

std::vector<TargetClear> target_clears(const WorkDraw& draw) {
    const Registers& state = *draw.state;
    const Rectangle rectangle = cleared_rectangle(state);
    std::vector<TargetClear> clears;
    const auto add = [&](const Surface& target, bool depth) -> TargetClear* {
        if (target.format == Format::None) return nullptr;
        clears.push_back({.target = target, .depth = depth, .bytes = {}, .fill = {}});
        clears.back().fill.rectangle = rectangle;
        return &clears.back();
    };
    const auto fill = [](TargetClear& target) -> PixelFill& { return target.fill; };
    for (unsigned i = 0; i < ColorTargets; ++i) {
        const Surface& target = state.targets.color[i];
        TargetClear* const color = add(target, false);
        if (!color || !draw.clear.color) continue;
        color->bytes = written_color_bytes(target.format, state.blend.write_mask);
        fill(*color) = color_fill(
            state, target.format, cleared_color(state.fragment, i, draw.clear.color_value));
    }
    const Format format = state.targets.depth.format;
    TargetClear* const depth = add(state.targets.depth, true);
    if (!depth || !(draw.clear.depth || draw.clear.stencil)) return clears;
    depth->bytes = cleared_depth_bytes(format, draw.clear, state.stencil.front.write_mask);
    fill(*depth) = depth_fill(state, format, draw.clear);
    return clears;
}

} // namespace ffgpu::work
