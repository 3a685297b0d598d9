#include "tools/files/npy_file.h"

#include "model/base/whole_file.h"

#include <bit>
#include <string_view>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::size_t Alignment = 64; // of the values
constexpr std::string_view Magic("\x93NUMPY\x01\x00", 8);

static_assert(std::endian::native == std::endian::little);

} // namespace

void write_npy(const std::string& path, std::size_t columns, std::span<const float> values) {
    std::string text =
        fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}), }}",
                    columns == 0 ? 0 : values.size() / columns,
                    columns);
    constexpr std::size_t Before = Magic.size() + 2;
    while ((Before + text.size() + 1) % Alignment != 0)
        text += ' ';
    text += '\n';
    std::string head(Magic);
    head += static_cast<char>(text.size() & 0xff);
    head += static_cast<char>(text.size() >> 8);
    WholeFile file(path);
    file.write(head + text);
    file.write(std::as_bytes(values));
    file.commit();
}

} // namespace ffgpu::tools
