// DeviceMemory: the GPU's memory, one zeroed range that the host backs page by page as it is
// touched.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

class DeviceMemory {
public:
    static constexpr std::uint64_t DefaultBytes = std::uint64_t{512} << 20;

    // Readable and writable beyond the end, so that a vector gather of whole words may overrun.
    static constexpr std::size_t SlackBytes = 64;

    explicit DeviceMemory(std::uint64_t bytes = DefaultBytes);
    ~DeviceMemory();
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    // Zeroes again, without pages of the host.
    void clear();

    std::uint64_t size() const { return bytes_.size(); }
    std::span<std::byte> bytes() { return bytes_; }
    std::span<const std::byte> bytes() const { return bytes_; }

    // True where [at, at + length) lies inside.
    bool contains(std::uint64_t at, std::uint64_t length) const {
        return at <= size() && length <= size() - at;
    }

private:
    std::span<std::byte> bytes_;
};

} // namespace ffgpu
