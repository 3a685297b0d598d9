// CommandCheck: checks command streams that came from a file: that they are well formed, that each
// field holds a value of its kind, and that what they point to lies within the device's memory.

#pragma once

#include "model/device/commands.h"

#include <cstdint>
#include <span>
#include <string>

namespace ffgpu::capture {

class CommandCheck {
public:
    explicit CommandCheck(std::uint64_t memory_bytes = 0)
        : memory_bytes_(memory_bytes) {}

    // What is wrong, in a sentence; empty if nothing is. Streams come in order: a draw is checked
    // against the registers written before it.
    std::string find_mistake(std::span<const std::uint32_t> words);
    std::string find_mistake(const Surface& surface) const;

private:
    std::string check_command(Opcode opcode, std::span<const std::uint32_t> payload);
    std::string check_register(std::span<const std::uint32_t> payload);
    std::string check(const DrawCommand& draw) const;
    std::string check(const DrawImageCommand& image) const;
    std::string check(const CopyRectangleCommand& copy) const;
    std::string check(const TextureImage& image) const;
    std::string check(const Targets& targets) const;
    std::string check(const VertexFormat& format);
    bool is_inside(std::uint64_t address, std::uint64_t bytes) const {
        return address + bytes <= memory_bytes_;
    }

    std::uint64_t memory_bytes_;
    std::uint32_t vertex_words_ = VertexFormat{}.stride;
};

} // namespace ffgpu::capture
