// What a unit asks of the memory system, and who asks.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace ffgpu::timing {

enum class Client : std::uint8_t {
    Command,
    Vertex,
    Texture,
    Depth,
    Color,
    Index,
    Host,
    ScanOut,
    Parameter,
    Count
};
inline constexpr std::size_t Clients = static_cast<std::size_t>(Client::Count);
inline constexpr std::array<std::string_view, Clients> ClientNames{
    "command", "vertex", "texture", "depth", "color", "index", "host", "scan_out", "parameter"};

struct MemoryRequest {
    std::uint64_t address = 0;
    std::uint32_t bytes = 0;
    bool write = false;
    Client client = Client::Command;
    std::uint64_t ticket = 0; // reads: the fill that it completes
    std::uint64_t issued = 0; // cycle in which the client asked; its port sets it
    std::size_t port = 0;     // of the arbiter, by which it came; the arbiter sets it
    std::uint64_t number = 0; // of those that came there before it; the arbiter sets it

    std::string key() const;
};

} // namespace ffgpu::timing
