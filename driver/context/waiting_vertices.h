// For those who follow a program's calls from outside.

#pragma once

#include <cstdint>

namespace ffgpu::gl {

// How many vertices of the calling thread's context wait to be drawn, of glBegin/glEnd pairs that
// are merged; 0 where there is no context.
std::uint32_t waiting_vertices();

// Something waits, or is being drawn that did.
bool vertices_wait();

} // namespace ffgpu::gl
