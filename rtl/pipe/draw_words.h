// A compiled draw as the words that the pipe is told.

#pragma once

#include "model/gpu/draw_context.h"
#include "rtl/bundles/draw.h"
#include "rtl/bundles/texture_words.h"

#include <array>
#include <vector>

namespace ffgpu::rtl {

DrawWords draw_words(const DrawContext& context);
std::array<TextureContext, TextureUnits> texture_contexts(const DrawContext& context);

// The planes that a record's fragments are interpolated from.
std::vector<PlaneWrite> plane_writes(const InterpolantLayout& layout, const SetupRecord& record);

} // namespace ffgpu::rtl
