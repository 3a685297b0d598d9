// CaptureWriter: a Device that passes all calls on to another, and records them in an .ffc file
// from begin() to end(). The file begins with what the device holds then, so that it stands by
// itself: a capture of frames A to B is a correct trim of any trace.
//
// The one thing a snapshot misses is the occlusion counter of a query that is under way.

#pragma once

#include "model/capture/register_shadow.h"
#include "model/device/device.h"

#include <cstdio>
#include <memory>
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
    bool is_recording() const { return file_ != nullptr; }

    // Tells which picture a frame ended with.
    void frame_shown(std::uint32_t number, const Surface& picture);

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override;
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void record_snapshot();
    void record_write(DeviceAddress at, std::span<const std::byte> bytes);
    void record_commands(std::span<const std::uint32_t> words);
    void put_u32(std::uint32_t value);
    void put_bytes(const void* bytes, std::size_t count);
    void begin_record(std::uint8_t kind, std::size_t bytes);
    void write_chunk();
    void write_file(const void* bytes, std::size_t count);

    Device& device_;
    RegisterShadow shadow_;
    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::vector<std::byte> chunk_;
    std::vector<std::byte> compressed_;
};

} // namespace ffgpu::capture
