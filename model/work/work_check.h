// What must hold of a command that comes from a file, before anybody places or times it.

#pragma once

#include "model/work/whole_command.h"

namespace ffgpu::work {

// Throws InputError that says what is wrong.
void check_draw(const WorkDraw& draw);
void check_surface(const Surface& surface);

// The quad's values are as many as its masks and state say.
bool values_fit(const WholeCommand& command, std::size_t quad);

// The same: each quad belongs to a piece that geometry made, and lies in its box. A draw whose
// primitives are not told has none.
void check_pieces(const WholeCommand& command);

} // namespace ffgpu::work
