// CaptureReader: plays an .ffc file on a device. What the file holds is checked before a device
// sees it, so that no file can make it fail: a damaged one throws InputError, naming the file, the
// place and what was expected, after everything before it was played.

#pragma once

#include "model/capture/command_check.h"
#include "model/device/device.h"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ffgpu::capture {

struct ShownPicture {
    std::uint32_t frame = 0; // as it was numbered when it was captured
    Surface picture;         // Format None: there is none.
};

class CaptureReader {
public:
    // Whether the file begins like a capture. False if it cannot be read at all.
    static bool is_capture(const std::string& path);

    // Throws InputError.
    explicit CaptureReader(std::string path);

    // Of the device that was captured; one to play it on needs as much.
    std::uint64_t memory_size() const { return memory_size_; }

    // The number that the first frame had when it was captured.
    std::uint32_t first_frame() const { return first_frame_; }

    // Plays up to the end of the next frame; nothing at the end of the capture.
    std::optional<ShownPicture> play_frame(Device& device);

    // Back to the first frame, for a device in its initial state.
    void rewind();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void read_header();
    bool next_chunk();
    void play_write(Device& device);
    void play_read(Device& device);
    void play_commands(Device& device);
    ShownPicture take_shown();
    void need_range(std::uint32_t address, std::uint64_t bytes) const;

    std::uint32_t take_u32();
    std::span<const std::byte> take(std::size_t bytes);
    std::size_t read_file(std::span<std::byte> bytes);
    [[noreturn]] void damaged(const std::string& what) const;

    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::uint64_t memory_size_ = 0;
    std::uint32_t first_frame_ = 0;
    std::uint64_t file_position_ = 0;
    std::uint64_t chunk_position_ = 0; // of the chunk, in the file
    std::vector<std::byte> compressed_;
    std::vector<std::byte> chunk_;
    std::size_t at_ = 0; // in chunk_
    CommandStream commands_;
    CommandCheck check_;
    std::vector<std::byte> scratch_;
};

} // namespace ffgpu::capture
