// Executes a display list's vertex block.

#pragma once

#include "driver/lists/display_list.h"

namespace ffgpu::gl {

class VertexContext;

void execute_block(VertexContext& context, VertexBlock& block);

} // namespace ffgpu::gl
