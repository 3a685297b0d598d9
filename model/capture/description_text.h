// The description of a contract as the text that a capture begins with, a line each:
//
//     enumeration NAME VALUES...
//     register NAME ADDRESS COUNT WORDS        (command NAME OPCODE ..., surface NAME 0 ...)
//     field NAME INDEX WORD LSB WIDTH TYPE RESETS...
//
// Fields follow what they are fields of. TYPE is unsigned, signed, float or an enumeration; the
// resets, one an element, are hexadecimal.

#pragma once

#include "model/device/description.h"

#include <string>
#include <string_view>

namespace ffgpu::capture {

std::string description_text(const Description& description);

// Throws InputError, naming the line. What it returns is sound: fields lie within their words, and
// enumerations are there; its size is bounded by the text's.
Description parse_description(std::string_view text);

} // namespace ffgpu::capture
