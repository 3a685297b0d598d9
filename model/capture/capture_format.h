// The .ffc file: the calls that a Device got, as a file. docs/capture_format.md describes it byte
// by byte. A header, then chunks (chunk_file.h); the first holds the description of the contract
// that the file was written under, the others hold records. All numbers are little endian.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ffgpu::capture {

constexpr std::array<char, 8> Magic{'f', 'f', 'g', 'p', 'u', 'c', 'a', 'p'};
constexpr std::uint32_t Version = 4;
constexpr std::uint32_t OldestVersion = 3; // Its snapshot has no end record.

struct Header {
    std::uint32_t version = Version;
    std::uint64_t memory_bytes = 0; // of the device
    std::uint32_t first_frame = 0;  // the number of the first frame
};
constexpr std::size_t HeaderBytes = Magic.size() + 16;

enum class Record : std::uint8_t {
    WriteMemory = 1, // u32 address, u32 bytes, the bytes
    ReadMemory = 2,  // u32 address, u32 bytes
    Submit = 3,      // u32 words, the words
    Finish = 4,
    Shown = 5,       // u32 frame number, the words of a Surface: the picture that was handed over
    SnapshotEnd = 6, // u32 number of the first draw: what came before restores, and is no work
};

// Chunks are about that large; one record can make its chunk larger, but not beyond MaxChunkBytes.
constexpr std::size_t ChunkBytes = std::size_t{1} << 20;
constexpr std::size_t MaxChunkBytes = std::size_t{1} << 26;
constexpr std::size_t MaxRecordBytes = std::size_t{1} << 25;
constexpr std::size_t MaxDescriptionBytes = std::size_t{1} << 20;

} // namespace ffgpu::capture
