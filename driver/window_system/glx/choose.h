// Selection and order of configurations (GLX 1.4, 3.3.3, table 3.4; glXChooseVisual, 3.3.1).

#pragma once

#include "driver/window_system/glx/configs.h"

#include <map>
#include <optional>
#include <vector>

namespace ffgpu::gl {

// What a program asks for: attribute and value. GLX_DONT_CARE matches all.
using Wishes = std::map<int, int>;

// glXChooseFBConfig's list, with the defaults where it says nothing. Nothing: it is malformed.
std::optional<Wishes> read_config_wishes(const int* attributes);
// glXChooseVisual's list: booleans stand alone, an absent one means no.
std::optional<Wishes> read_visual_wishes(const int* attributes);

// The configurations that have all that is asked for, the best first.
std::vector<const GlxConfig*> choose_configs(const std::vector<GlxConfig>& configs,
                                             const Wishes& wishes);

} // namespace ffgpu::gl
