#include "driver/trace/reader/container.h"

#include "driver/trace/reader/input_file.h"
#include "model/base/input_error.h"

#include <array>
#include <cstdint>

namespace ffgpu::trace {

std::unique_ptr<Container> open_container(const std::string& path) {
    auto file = std::make_unique<InputFile>(path);
    std::array<std::byte, 4> head{};
    file->read(head);
    file->rewind();
    const auto is = [&](std::initializer_list<std::uint8_t> magic) {
        std::size_t i = 0;
        for (const std::uint8_t byte : magic)
            if (std::to_integer<std::uint8_t>(head[i++]) != byte) return false;
        return true;
    };
    if (is({'a', 't'})) return open_snappy(std::move(file));
    if (is({0x1f, 0x8b})) return open_gzip(std::move(file));
    if (is({0x28, 0xb5, 0x2f, 0xfd})) return open_zstd(std::move(file));
    throw InputError(path + ": byte 0: not a trace: expected an apitrace file in a Snappy ('at'), "
                            "gzip or Zstandard container");
}

} // namespace ffgpu::trace
