// CaptureWriter: a Device that passes all calls on to another, and records them in an .ffc file
// from begin() to end(). The file begins with what the device holds then, so that it stands by
// itself: a capture of frames A to B is a correct trim of any trace.
//
// The one thing a snapshot misses is the occlusion counter of a query that is under way.

#pragma once

#include "model/capture/capture_format.h"
#include "model/capture/chunk_file.h"
#include "model/device/description.h"
#include "model/device/device.h"
#include "model/device/register_file.h"

#include <optional>
#include <string>
#include <vector>

namespace ffgpu::capture {

class CaptureWriter : public Device {
public:
    explicit CaptureWriter(Device& device);
    ~CaptureWriter() override;

    // Throws InputError if the file cannot be written; so do end() and the calls between them.
    void begin(const std::string& path, std::uint32_t first_frame);
    void end();
    // The device's next draw has that number (0 for a new device).
    void number_draws_from(std::uint32_t number) { draws_ = number; }
    bool is_recording() const { return file_.has_value(); }

    // Tells which picture a frame ended with.
    void frame_shown(std::uint32_t number, const Surface& picture);

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override;
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    void record_snapshot();
    void record_write(DeviceAddress at, std::span<const std::byte> bytes);
    void record_commands(std::span<const std::uint32_t> words);
    void begin_record(Record record, std::size_t bytes);

    Device& device_;
    RegisterFile registers_;  // the device's
    std::uint32_t draws_ = 0; // that it was told to draw
    std::optional<ChunkWriter> file_;
};

// What a capture begins with, before its first record.
void write_beginning(ChunkWriter& file, const Header& header, const Description& contract);

} // namespace ffgpu::capture
