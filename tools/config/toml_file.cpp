#include "tools/config/toml_file.h"

#include "model/base/input_error.h"

#include <fstream>
#include <iterator>

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
    std::string text;
    try {
        std::ifstream file(path, std::ios::binary);
        text.assign(std::istreambuf_iterator<char>(file), {});
        if (!file.is_open() || file.bad()) throw InputError(path + ": cannot be read");
    } catch (const std::ios_base::failure&) { // A folder opens as a file does.
        throw InputError(path + ": cannot be read");
    }
    return parse_toml(text, path);
}

} // namespace ffgpu::tools
