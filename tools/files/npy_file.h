// Arrays for NumPy: the .npy format, version 1.0 (numpy.lib.format).

#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ffgpu::tools {

// Of shape (rows, columns), row after row. Throws InputError where it cannot be written.
void write_npy(const std::string& path, std::size_t columns, std::span<const float> values);

} // namespace ffgpu::tools
