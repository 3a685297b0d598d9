// What must hold of a command that comes from a file, before anybody places or times it.

#pragma once

#include "model/packets/work_stream.h"

namespace ffgpu::work {

// Throws InputError that says what is wrong.
void check_draw(const WorkDraw& draw);

} // namespace ffgpu::work
