// TargetClear: what a clear does to one of its targets.

#pragma once

#include "model/work/surface_fill.h"
#include "model/work/surface_lines.h"
#include "model/work/whole_command.h"

#include <vector>

namespace ffgpu::work {

struct TargetClear {
    Surface target;
    bool depth = false;
    PixelBytes bytes; // of a sample; none where it is not cleared
    SurfaceFill fill; // but for its place; without bits where it is not cleared
};

// What lies in the scissor and on each of the targets.
Rectangle cleared_rectangle(const Registers& state);

// Of each target that there is, depth at the end.
std::vector<TargetClear> target_clears(const WorkDraw& draw);

// Whether the command asks for anything of it.
inline bool is_asked_for(const ClearCommand& clear, bool depth) {
    return depth ? clear.depth || clear.stencil : clear.color;
}

} // namespace ffgpu::work
