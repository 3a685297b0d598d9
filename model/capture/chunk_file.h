// Files of chunks, each compressed on its own:
//
//     u32 bytes of the content, u32 bytes of the compressed chunk, the chunk (Zstandard, checksum)
//
// A chunk of 0 bytes ends the file. All numbers are little endian.

#pragma once

#include "model/base/whole_file.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ffgpu::capture {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// Throws InputError if the file cannot be written. Without end() there is none.
class ChunkWriter {
public:
    explicit ChunkWriter(const std::string& path);

    // What stands before the chunks; put before the first of them.
    void write_plain(std::span<const std::byte> bytes);

    void put_u32(std::uint32_t value);
    void put_bytes(const void* bytes, std::size_t count);

    std::size_t pending() const { return chunk_.size(); } // bytes of the chunk under way
    void write_chunk();                                   // ends it; an empty one is none
    void end();

private:
    WholeFile file_;
    std::vector<std::byte> chunk_;
    std::vector<std::byte> compressed_;
};

// Throws InputError, with the file's name and the place of the chunk.
class ChunkReader {
public:
    explicit ChunkReader(std::string path);

    const std::string& path() const { return path_; }
    void rewind();

    // What stands before the chunks; how many bytes there were.
    std::size_t read_plain(std::span<std::byte> bytes);

    // False at the end mark.
    bool next_chunk(std::size_t most_bytes);
    bool chunk_ended() const { return at_ == chunk_.size(); }
    std::size_t left() const { return chunk_.size() - at_; }

    std::uint32_t take_u32();
    std::span<const std::byte> take(std::size_t bytes);
    void take_words(std::size_t count, std::vector<std::uint32_t>& words);

    [[noreturn]] void damaged(const std::string& what) const;

private:
    std::string path_;
    File file_;
    std::uint64_t file_position_ = 0;
    std::uint64_t chunk_position_ = 0; // of the chunk, in the file
    std::vector<std::byte> compressed_;
    std::vector<std::byte> chunk_;
    std::size_t at_ = 0; // in chunk_
};

} // namespace ffgpu::capture
