// What a line of draws.csv tells of a command's work.

#pragma once

#include "model/work/whole_command.h"
#include "tools/draws/draw_notes.h"

#include <string>
#include <string_view>

namespace ffgpu::tools {

// "call,function,primitive,...", and the values in that order.
std::string_view draw_fact_names();
std::string draw_facts(const work::WholeCommand& command, const DrawNote& note);

} // namespace ffgpu::tools
