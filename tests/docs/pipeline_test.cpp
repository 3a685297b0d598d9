// The tour's pages, docs/pipeline, hold what ffgpu draws and counts.

#include <cstdlib>
#include <string>

#include <catch2/catch.hpp>

TEST_CASE("each picture and figure of the tour is what ffgpu draws and counts") {
    const std::string source = FFGPU_SOURCE_DIR;
    const std::string command =
        "python3 '" + source + "/docs/pipeline/make.py' --check --ffgpu '" FFGPU_BINARY "'";
    CHECK(std::system(command.c_str()) == 0);
}
