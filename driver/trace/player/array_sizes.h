// How much a GL command reads through its pointer parameter, from its other parameters. A trace
// whose blob is shorter than that (a damaged one: tracers record as much as is read) gets zeroes
// beyond the end instead of a crash.

#pragma once

#include "driver/trace/reader/call.h"

#include <cstdint>
#include <string_view>

namespace ffgpu::gl {
class Context;
}

namespace ffgpu::trace {

// Elements for a typed pointer, bytes for a void pointer. Huge where the parameters overflow.
using ArraySize = std::uint64_t (*)(const Call& call, const gl::Context& context);

// No typed pointer without a rule reads more than this (a matrix).
constexpr std::uint64_t UsualArraySize = 16;
constexpr std::uint64_t HugeArray = std::uint64_t{1} << 28;

// Bytes of the longest index array of glMultiDrawElements(mode, count, type, indices, primcount).
std::uint64_t longest_index_array(const Call& call);

// The rule of a command of that name (without "gl"), vendor suffixes included; null:
// UsualArraySize.
ArraySize find_array_size(std::string_view name);

} // namespace ffgpu::trace
