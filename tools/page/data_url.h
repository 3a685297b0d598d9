// data: URLs, by which a page holds its pictures.

#pragma once

#include <string>
#include <string_view>

namespace ffgpu::tools {

std::string data_url(std::string_view type, std::string_view bytes);

// Of the bytes alone.
constexpr std::size_t data_url_size(std::size_t bytes) {
    return (bytes + 2) / 3 * 4;
}

} // namespace ffgpu::tools
