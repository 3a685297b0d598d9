#include "tools/explain/frame_tape.h"

#include <algorithm>
#include <utility>

namespace ffgpu::tools {
namespace {

std::vector<FrameTape::Piece> memory_of(FunctionalGpu& gpu) {
    constexpr std::uint64_t PieceBytes = std::uint64_t{64} << 10;
    std::vector<FrameTape::Piece> pieces;
    std::vector<std::byte> bytes;
    for (std::uint64_t at = 0; at < gpu.memory_size(); at += PieceBytes) {
        bytes.resize(std::min(PieceBytes, gpu.memory_size() - at));
        gpu.read_memory(static_cast<DeviceAddress>(at), bytes);
        const bool zero =
            std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0}; });
        if (!zero) pieces.push_back({static_cast<DeviceAddress>(at), bytes});
    }
    return pieces;
}

} // namespace

void FrameTape::prepare(FunctionalGpu& gpu) const {
    for (const Piece& piece : memory)
        gpu.write_memory(piece.at, piece.bytes);
    CommandStream stream;
    write_changes(Registers{}, registers, stream);
    gpu.submit(stream);
    gpu.number_from(frame, first_draw);
}

void FrameTape::play(const TapeStep& step, FunctionalGpu& gpu) {
    switch (step.kind) {
    case TapeStep::Kind::Command:
        return gpu.submit(step.command);
    case TapeStep::Kind::Write:
        return gpu.write_memory(step.at, step.bytes);
    case TapeStep::Kind::Read: {
        std::vector<std::byte> bytes(step.size);
        return gpu.read_memory(step.at, bytes);
    }
    }
}

void TapeDevice::start(std::uint32_t frame, const CallLog* calls) {
    calls_ = calls;
    keeps_ = true;
    tape_ = {.frame = frame,
             .first_draw = next_draw_,
             .memory = memory_of(gpu_),
             .registers = gpu_.registers(),
             .steps = {}};
}

void TapeDevice::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    gpu_.write_memory(at, bytes);
    if (keeps_)
        add({.kind = TapeStep::Kind::Write, .at = at, .bytes = {bytes.begin(), bytes.end()}});
}

void TapeDevice::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    gpu_.read_memory(at, bytes);
    if (keeps_) add({.kind = TapeStep::Kind::Read, .at = at, .size = bytes.size()});
}

void TapeDevice::submit(const CommandStream& commands) {
    gpu_.submit(commands); // Throws where the stream is damaged: what comes below is sound.
    for_each_command(commands.words, [this](const CommandReader& reader) {
        next_draw_ += is_numbered(reader.opcode());
        if (!keeps_) return;
        TapeStep step;
        step.command.words.assign(reader.whole().begin(), reader.whole().end());
        if (calls_ && reader.opcode() == Opcode::Draw) step.vertices = calls_->waiting();
        add(std::move(step));
    });
}

void TapeDevice::add(TapeStep step) {
    if (calls_) step.call = calls_->call();
    tape_.steps.push_back(std::move(step));
}

} // namespace ffgpu::tools
