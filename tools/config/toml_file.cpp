#include "tools/config/toml_file.h"

#include "model/base/input_error.h"

#include <array>
#include <fstream>
#include <string>

#include <fmt/format.h>

namespace ffgpu::tools {

toml::table parse_toml(const std::string& text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format(
            "{}:{}: {}", source, error.source().begin.line, std::string(error.description())));
    }
}

toml::table read_toml_file(const std::string& path) {
    constexpr std::size_t Most = 16u << 20;
    std::string text;
    try {
        std::ifstream file(path, std::ios::binary);
        std::array<char, 65536> part;
        do {
            file.read(part.data(), part.size());
            text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        } while (file && text.size() <= Most);
        if (!file.is_open() || file.bad()) throw InputError(path + ": cannot be read");
    } catch (const std::ios_base::failure&) { // A folder opens as a file does.
        throw InputError(path + ": cannot be read");
    }
    if (text.size() > Most)
        throw InputError(fmt::format("{}: is larger than {} MiB", path, Most >> 20));
    return parse_toml(text, path);
}

} // namespace ffgpu::tools
