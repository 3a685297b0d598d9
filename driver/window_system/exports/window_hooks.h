// What the window system does ahead of a few GL commands.

#pragma once

#include "driver/commands/command.h"

namespace ffgpu::gl {

// The surfaces take the window's new size, so that the picture drawn after a resize has it.
void before_viewport();
// What was drawn to the front buffer so far must be shown even if the back buffer is next.
void before_draw_buffer();

template <Command Id>
void before() {
    if constexpr (Id == Command::Viewport) before_viewport();
    if constexpr (Id == Command::DrawBuffer || Id == Command::DrawBuffers) before_draw_buffer();
}

} // namespace ffgpu::gl
