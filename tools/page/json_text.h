// JSON as text, whatever names of files stand in it: JSON is UTF-8, a file's name may be any bytes.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace ffgpu::tools {

// `indent` spaces a level; below 0: all on one line. A byte that is no UTF-8 becomes U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json, int indent = -1) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace ffgpu::tools
