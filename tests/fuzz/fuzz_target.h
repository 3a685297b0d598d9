// A fuzz target: takes any bytes and has to come back, whatever they are. What is wrong with them
// it tells by an InputError, which the target catches; any other exception, a crash, a finding of a
// sanitizer or memory without bound is a fault of ffgpu.
//
// A target is built twice: with clang's libFuzzer, which looks for bytes that reach new code
// (./dev fuzz), and with a main() that plays a corpus and mutations of it, drawn by a seed (ctest).

#pragma once

#include <cstdint>
#include <span>

namespace ffgpu::fuzz {

using Bytes = std::span<const std::uint8_t>;

// Of the target.
void run(Bytes bytes);

} // namespace ffgpu::fuzz
