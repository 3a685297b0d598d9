// A fragment's way as lines of text: parts of history_text().

#pragma once

#include "tools/explain/pixel_history.h"

#include <string>

namespace ffgpu::tools {

// "(255, 128, 0, 255)"
std::string color_text(const Rgba& color);
std::string color_text(std::uint32_t rgba8);

// From the primitive to the depth.
std::string geometry_text(const FragmentNote& fragment);
// A texture unit: coordinates, levels, texels.
std::string texture_text(const FragmentNote& fragment, const TextureNote& texture);
// From the environments to the coverage.
std::string shading_text(const FragmentNote& fragment);
// From the sample mask to what is stored, and the fragment's end.
std::string tests_text(const FragmentNote& fragment);

} // namespace ffgpu::tools
