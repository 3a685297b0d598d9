// A device capture as text: a line a record or command, registers, fields and enumerators by name.

#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace ffgpu::tools {

struct DumpOptions {
    std::string input;
    bool words = false; // as numbers: a word a line, with its command in a comment
};

// Hands out the text piece by piece. Throws InputError; what stands before the damage is out.
void dump_capture(const DumpOptions& options, const std::function<void(std::string_view)>& out);

} // namespace ffgpu::tools
