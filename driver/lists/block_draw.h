// Executes a display list's vertex block.

#pragma once

#include "driver/lists/display_list.h"

namespace ffgpu::gl {

class Context;

void execute_block(Context& context, VertexBlock& block);

} // namespace ffgpu::gl
