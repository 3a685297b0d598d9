#include "tools/page/data_url.h"

#include <cstdint>

namespace ffgpu::tools {

// Base 64 of RFC 4648.
std::string data_url(std::string_view type, std::string_view bytes) {
    constexpr std::string_view Digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string url = "data:";
    url.append(type).append(";base64,");
    url.reserve(url.size() + data_url_size(bytes.size()));
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8 |
                    (at + i < bytes.size() ? static_cast<std::uint8_t>(bytes[at + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i)
            url += at + i <= bytes.size() ? Digits[three >> (18 - 6 * i) & 63] : '=';
    }
    return url;
}

} // namespace ffgpu::tools
