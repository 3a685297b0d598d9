// The dependency rule as a test: each layer includes itself and the layers listed for it, nothing
// else. docs/architecture.md draws the same arrows.

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;

using Layers = std::set<std::string>;

const Layers Contract = {"model/base", "model/device"};
const Layers UnitMaySee = {
    "model/base", "model/device", "model/packets", "model/arith", "model/memory"};

const std::map<std::string, Layers> Allowed = {
    {"model/base", {}},
    {"model/device", {"model/base"}},
    {"model/packets", Contract},
    {"model/arith", {"model/base"}},
    {"model/memory", {"model/base", "model/device", "model/packets", "model/arith"}},
    {"model/geometry", UnitMaySee},
    {"model/raster", UnitMaySee},
    {"model/texture", UnitMaySee},
    {"model/fragment", UnitMaySee},
    {"model/gpu",
     {"model/base",
      "model/device",
      "model/packets",
      "model/arith",
      "model/memory",
      "model/geometry",
      "model/raster",
      "model/texture",
      "model/fragment"}},
    {"model/capture", Contract},
    {"model/timing", {"model/base", "model/device", "model/packets", "model/arith"}},
    // The raster position is a vertex that the driver computes with the device's arithmetic.
    {"driver", {"model/base", "model/device", "model/arith"}},
    {"driver/trace", {"model/base", "model/device", "driver"}},
    {"driver/window_system",
     {"model/base", "model/device", "model/packets", "model/gpu", "model/capture", "driver"}},
    {"techniques", {}}, // of use to any OpenGL program: it knows no part of the machine
    {"tools",
     {"model/base",
      "model/device",
      "model/packets",
      "model/gpu",
      "model/capture",
      "model/timing",
      "driver",
      "driver/trace",
      "driver/window_system"}},
};

// The longest layer that the path lies in.
std::string layer_of(std::string_view path) {
    std::string found;
    for (const auto& [layer, allowed] : Allowed) {
        if (path.starts_with(layer + '/') && layer.size() > found.size()) found = layer;
    }
    return found;
}

bool is_source(const fs::path& path) {
    return path.extension() == ".h" || path.extension() == ".cpp" || path.extension() == ".inc";
}

TEST_CASE("includes point down only") {
    const fs::path root = FFGPU_SOURCE_DIR;
    for (const auto& [layer, allowed] : Allowed) {
        if (!fs::exists(root / layer)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
            const std::string path = fs::relative(entry.path(), root).string();
            if (!is_source(entry.path()) || layer_of(path) != layer) continue;
            std::ifstream file(entry.path());
            for (std::string line; std::getline(file, line);) {
                if (!line.starts_with("#include \"")) continue;
                const std::string target = layer_of(std::string_view(line).substr(10));
                INFO(entry.path().string() << " may not have: " << line);
                CHECK((target.empty() || target == layer || allowed.contains(target)));
            }
        }
    }
}

TEST_CASE("no OpenGL token stands below the driver") {
    const fs::path root = FFGPU_SOURCE_DIR;
    for (const auto& entry : fs::recursive_directory_iterator(root / "model")) {
        if (!is_source(entry.path())) continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            INFO(entry.path().string() << ": " << line);
            CHECK(line.find("#include <GL/") == std::string::npos);
        }
    }
}

} // namespace
} // namespace ffgpu
