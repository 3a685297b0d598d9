// DrawWatch: a Device that passes all calls on and follows the draws: it tells of each, may leave
// some out, and stops behind them, so that somebody can look at the targets.

#pragma once

#include "model/device/device.h"
#include "model/device/register_file.h"
#include "tools/frames/frame_range.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ffgpu::tools {

// What is known of a draw when it comes.
struct WatchedDraw {
    std::uint32_t number = 0;
    bool is_image = false;
    PrimitiveType primitive = PrimitiveType::Triangles; // of others than images
};

class DrawWatch final : public Device {
public:
    struct Listener {
        std::function<void(const WatchedDraw&)> before = [](const WatchedDraw&) {};
        // All that came so far has been submitted.
        std::function<void(std::uint32_t draw, const Targets&)> behind{}; // may be empty
    };

    // Draws and drawn images have numbers, from the device's first on. Those outside `range` cover
    // nothing.
    DrawWatch(Device& device, const FrameRange& range, Listener listener);

    // The device's next draw has that number.
    void number_from(std::uint32_t draw) {
        if (first_ == next_) first_ = draw;
        next_ = draw;
    }
    // The draws that count for missing_draws() are those from here on.
    void start() { first_ = next_; }

    // A line that tells which draws came, if the range has later ones or none of these; else
    // nothing.
    std::string missing_draws() const;

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        device_.write_memory(at, bytes);
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        device_.read_memory(at, bytes);
    }
    void submit(const CommandStream& commands) override;
    void finish() override { device_.finish(); }
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    void draw(const CommandReader& reader);
    void flush();

    Device& device_;
    const FrameRange range_;
    const Listener listener_;
    RegisterFile registers_;
    CommandStream waiting_;
    std::uint32_t first_ = 0, next_ = 0;
};

} // namespace ffgpu::tools
