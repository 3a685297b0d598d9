// A file of the source tree, read whole; the test fails where there is none.

#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::docs {

inline std::string read_source(const std::string& path) {
    std::ifstream file(std::string(FFGPU_SOURCE_DIR "/") + path);
    INFO(path);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace ffgpu::docs
