// The shapes that set-up knows; each fills the record's box, edges and coverage kind and returns
// false where no pixel is covered.

#pragma once

#include "model/raster/setup.h"

namespace ffgpu {

bool set_up_triangle(const SetupContext& context,
                     const Primitive& primitive,
                     SetupRecord& record,
                     bool all_planes);
bool set_up_line(const SetupContext& context, const Primitive& primitive, SetupRecord& record);
bool set_up_point(const SetupContext& context, const Primitive& primitive, SetupRecord& record);

} // namespace ffgpu
