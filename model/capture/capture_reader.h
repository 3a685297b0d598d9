// CaptureReader: plays an .ffc file on a device, one of another release translated. What is damaged
// throws InputError, naming the file and the place, after everything before it was played. Streams
// of commands are judged by the device, as any that is submitted; the reader adds where they stand.

#pragma once

#include "model/capture/capture_format.h"
#include "model/capture/chunk_file.h"
#include "model/capture/translator.h"
#include "model/device/device.h"

#include <cstdint>
#include <memory>
#include <optional>
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

    // Restores what the device held when the capture began: no work of the captured program's. To
    // be called first; play_frame() does it where nobody did.
    void play_snapshot(Device& device);

    // The number that the first draw had, known when the snapshot is played. Captures of version 3
    // do not tell it, nor where their snapshot ends.
    std::uint32_t first_draw() const { return first_draw_; }

    // Plays up to the end of the next frame; nothing at the end of the capture.
    std::optional<ShownPicture> play_frame(Device& device);

    // Throws InputError unless a frame was played since the beginning: behind the last one, tells a
    // capture without any.
    void expect_frames() const;

    // Back to the first frame, for a device in its initial state.
    void rewind();

private:
    void read_beginning();
    void read_header();
    // Which it was; nothing at the end.
    std::optional<Record> play_record(Device& device);
    void take_snapshot_end();
    void play_write(Device& device);
    void play_read(Device& device);
    void play_commands(Device& device);
    void play_translated(Device& device);
    void take_shown();
    void need_range(std::uint32_t address, std::uint64_t bytes) const;

    // Adds the place in the file to an InputError.
    template <class Action>
    void at_place(Action&& action) const;

    ChunkReader file_;
    std::uint64_t memory_size_ = 0;
    std::uint32_t first_frame_ = 0;
    std::uint64_t next_frame_ = 0; // Numbers rise.
    std::uint32_t first_draw_ = 0;
    bool in_snapshot_ = false; // Its end record is to come.
    ShownPicture shown_;       // of the last record of that kind
    std::shared_ptr<const Translator> translator_;
    bool resets_pending_ = false; // commands_ are the resets, and come before all else
    std::vector<std::uint32_t> words_;
    CommandStream commands_;
    std::vector<std::byte> scratch_;
};

} // namespace ffgpu::capture
