// FrameTape: what the driver told the device in one frame, to be carried out again on another one:
// memory and registers as they were before it, then each command, write and read, with its call.

#pragma once

#include "model/gpu/functional_gpu.h"
#include "tools/frames/call_log.h"
#include "tools/frames/numbered_draws.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu::tools {

struct TapeStep {
    enum class Kind : std::uint8_t { Command, Write, Read };

    Kind kind = Kind::Command;
    CommandStream command{};        // Command: this one alone
    DeviceAddress at = 0;           // Write, Read
    std::vector<std::byte> bytes{}; // Write
    std::uint64_t size = 0;         // Read
    CallName call{};
    std::shared_ptr<const VertexCalls> vertices{}; // Command: see CallLog::waiting()

    Opcode opcode() const { return CommandStream::opcode(command.words[0]); }
    template <class Command>
    Command as() const {
        CommandReader reader(command.words);
        reader.next();
        return reader.command<Command>();
    }
};

struct FrameTape {
    struct Piece {
        DeviceAddress at = 0;
        std::vector<std::byte> bytes;
    };
    std::uint32_t frame = 0, first_draw = 0;
    std::vector<Piece> memory; // where it is not zero
    Registers registers;
    std::vector<TapeStep> steps;

    // Makes a new device what the frame's was before it.
    void prepare(FunctionalGpu& gpu) const;
    static void play(const TapeStep& step, FunctionalGpu& gpu);
};

// Passes all on to the GPU, and from start() on keeps it.
class TapeDevice final : public Device {
public:
    explicit TapeDevice(FunctionalGpu& gpu)
        : gpu_(gpu) {}

    void number_draws_from(std::uint32_t draw) { next_draw_ = draw; }
    // The frame under way is to be kept. `calls` may be null.
    void start(std::uint32_t frame, const CallLog* calls);
    const FrameTape& tape() const { return tape_; }

    std::uint64_t memory_size() const override { return gpu_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override { gpu_.finish(); }
    std::vector<const StatisticsGroup*> statistics() const override { return gpu_.statistics(); }

private:
    void add(TapeStep step);

    FunctionalGpu& gpu_;
    const CallLog* calls_ = nullptr;
    bool keeps_ = false;
    std::uint32_t next_draw_ = 0;
    FrameTape tape_;
};

} // namespace ffgpu::tools
