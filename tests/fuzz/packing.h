// Between files as ffgpu reads them and inputs that a fuzzer can change: inside of a file is
// compressed and has checksums, which no mutation would get right. Inputs hold what is inside.
//
//     trace        the stream of calls
//     capture      the header, u32 bytes of the first chunk, that chunk (the contract), the
//     records.
//                  0 bytes: this program's own contract stands there
//     work file    the magic and version; blocks, each kind (u8), items (u32), bytes (u32), bytes.
//                  A block of names of 0 bytes: this program's own
//
// What is short of bytes at the end is made of as many as there are.

#pragma once

#include "tests/fuzz/fuzz_target.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::fuzz {

std::vector<std::uint8_t> pack_trace(Bytes input);
std::vector<std::uint8_t> pack_capture(Bytes input);
std::vector<std::uint8_t> pack_work_file(Bytes input);

// Of files that are sound. Throws InputError.
std::vector<std::uint8_t> unpack_trace(const std::string& path);
std::vector<std::uint8_t> unpack_capture(const std::string& path);
std::vector<std::uint8_t> unpack_work_file(const std::string& path);

} // namespace ffgpu::fuzz
