// A program of the gallery drawn into memory, by OSMesa's calls: no window system.

#pragma once

#include "tests/gallery/oracles/compare.h"
#include "tests/gallery/programs/programs.h"

namespace ffgpu::gallery {

Picture draw_offscreen(const Program& program, bool broken);

} // namespace ffgpu::gallery
