#include "tools/files/shell_word.h"

#include <string_view>

namespace ffgpu::tools {

// Within '...' a quote ends the string, is escaped, and begins another.
std::string shell_quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string shell_word(const std::string& text) {
    constexpr std::string_view Plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
        "_-+./:,@%";
    const bool is_plain = !text.empty() && text.find_first_not_of(Plain) == std::string::npos;
    return is_plain ? text : shell_quoted(text);
}

} // namespace ffgpu::tools
