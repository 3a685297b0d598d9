// What the work stream tells of a piece beside its box.

#pragma once

#include "model/packets/interpolants.h"
#include "model/packets/work_stream.h"
#include "model/raster/setup_record.h"

namespace ffgpu {

// What set-up made of it: planes, and the blocks that its edges touch.
void add_set_up(const InterpolantLayout& layout, const SetupRecord& record, PieceBox& piece);

} // namespace ffgpu
