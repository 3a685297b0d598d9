// The name that someone who mistyped probably meant.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

// Of `names` (not empty) the first with the fewest letters to insert, delete or replace.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);

} // namespace ffgpu::tools
