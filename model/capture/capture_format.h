// The .ffc file: the calls that a Device got, as a file. docs/capture_format.md describes it byte
// by byte. A header, then chunks, each compressed on its own:
//
//     u32 bytes of the records, u32 bytes of the compressed chunk, the chunk (Zstandard, checksum)
//
// Records do not straddle chunks. A chunk of 0 bytes ends the file. All numbers are little endian.

#pragma once

#include "model/device/registers.h"

#include <array>
#include <cstdint>

namespace ffgpu::capture {

constexpr std::array<char, 8> Magic{'f', 'f', 'g', 'p', 'u', 'c', 'a', 'p'};
constexpr std::uint32_t Version = 2;

struct Header {
    std::uint32_t version = Version;
    std::uint32_t register_map = 0; // register_map_fingerprint() of the writer
    std::uint64_t memory_bytes = 0; // of the device
    std::uint32_t first_frame = 0;  // the number of the first frame
};
constexpr std::size_t HeaderBytes = Magic.size() + 20;

enum class Record : std::uint8_t {
    WriteMemory = 1, // u32 address, u32 bytes, the bytes
    ReadMemory = 2,  // u32 address, u32 bytes
    Submit = 3,      // u32 words, the words
    Finish = 4,
    Shown = 5, // u32 frame number, the words of a Surface: the picture that was handed over
};

// Chunks are about that large; one record can make its chunk larger, but not beyond MaxChunkBytes.
constexpr std::size_t ChunkBytes = std::size_t{1} << 20;
constexpr std::size_t MaxChunkBytes = std::size_t{1} << 26;
constexpr std::size_t MaxRecordBytes = std::size_t{1} << 25;

// Differs where a stream of commands means something else: number and sizes of the registers.
constexpr std::uint32_t register_map_fingerprint() {
    std::uint32_t hash = 2166136261u; // FNV-1a
    const auto add = [&](std::uint32_t value) { hash = (hash ^ value) * 16777619u; };
    constexpr Registers registers{};
    Registers::visit(registers, [&](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        Register copy = reg;
        visit_placed<Register>(
            copy, [&](const char*, auto&, unsigned word, unsigned lsb, unsigned width) {
                add(word << 16 | lsb << 8 | width);
            });
    });
    return hash;
}

} // namespace ffgpu::capture
