// Manual pages in troff, with the macros of man(7).

#pragma once

#include "tools/manual/program_text.h"

#include <string>

namespace ffgpu::tools {

// Of the program: its verbs.
std::string man_page(const ProgramText& program);
// Of a verb: its options.
std::string man_page(const ProgramText& program, const VerbText& verb);

} // namespace ffgpu::tools
