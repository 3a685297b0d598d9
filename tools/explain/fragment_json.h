// A fragment's way as JSON: part of history_json().

#pragma once

#include "tools/explain/pixel_history.h"

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

// [r, g, b, a]
nlohmann::ordered_json color_json(std::uint32_t rgba8);

// What a texture unit did, texel by texel.
nlohmann::ordered_json texture_json(const FragmentNote& fragment, const TextureNote& texture);

// Adds the fragment's stages to `json`.
void add_fragment_json(const FragmentNote& fragment, nlohmann::ordered_json& json);

} // namespace ffgpu::tools
