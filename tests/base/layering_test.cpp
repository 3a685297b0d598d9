// The dependency rule as a test: each layer includes itself and the layers listed for it, nothing
// else. layers.h lists them.

#include "tests/base/include_directives.h"
#include "tests/base/layers.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

namespace fs = std::filesystem;

// The longest layer that the path lies in.
std::string layer_of(std::string_view path) {
    std::string found;
    for (const auto& [layer, allowed] : Allowed) {
        if (path.starts_with(layer + '/') && layer.size() > found.size()) found = layer;
    }
    return found;
}

// Folders whose files are read.
const std::vector<std::string> Parts{"model", "driver", "tools", "techniques", "rtl"};

bool is_source(const fs::path& path) {
    static const std::set<std::string> types{".h", ".cpp", ".c", ".inl", ".inc"};
    return types.contains(path.extension().string());
}

// Calls visitor(path of the file, path that it includes), both from the root.
template <class Visitor>
void for_each_include(const fs::path& root, const std::string& folder, Visitor&& visitor) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        if (!is_source(entry.path())) continue;
        const std::string path = fs::relative(entry.path(), root).string();
        for (const Include& include : includes_of(text_of(entry.path())))
            visitor(path, include.path);
    }
}

std::string folder_of(const std::string& path) {
    return fs::path(path).parent_path().string();
}

using Arrows = std::map<std::string, std::set<std::string>>;

// All that can be reached from a folder, in one step or more.
std::set<std::string> reachable(const Arrows& arrows, const std::string& from) {
    std::set<std::string> found;
    std::vector<std::string> open{from};
    while (!open.empty()) {
        const auto next = arrows.find(open.back());
        open.pop_back();
        if (next == arrows.end()) continue;
        for (const std::string& folder : next->second)
            if (found.insert(folder).second) open.push_back(folder);
    }
    return found;
}

// Of a folder the others that it reaches and that reach it: its strongly connected component.
std::set<std::string> circle_of(const Arrows& arrows, const std::string& folder) {
    std::set<std::string> circle;
    for (const std::string& other : reachable(arrows, folder))
        if (other != folder && reachable(arrows, other).contains(folder)) circle.insert(other);
    return circle;
}

TEST_CASE("includes point down only") {
    const fs::path root = FFGPU_SOURCE_DIR;
    for (const std::string& part : Parts) {
        for_each_include(root, part, [&](const std::string& path, const std::string& included) {
            const std::string from = layer_of(path), to = layer_of(included);
            INFO(path << " may not include " << included);
            CHECK(!from.empty());
            // What is in none of the layers, as the tests, is nothing to build on.
            CHECK((!fs::exists(root / included) || !to.empty()));
            CHECK((to.empty() || to == from || Allowed.at(from).contains(to)));
        });
    }
}

// Otherwise an include could point anywhere unseen.
TEST_CASE("files of the layers are sources, and their includes name paths from the root") {
    const fs::path root = FFGPU_SOURCE_DIR;
    const std::set<std::string> others{".txt",
                                       ".py",
                                       ".in",
                                       ".map",
                                       ".sh",
                                       ".css",
                                       ".js",
                                       ".html",
                                       ".sv",
                                       ".vlt",
                                       ".smk",
                                       ".yaml"};
    for (const std::string& part : Parts)
        for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
            if (!entry.is_regular_file()) continue;
            INFO(entry.path().string());
            CHECK((is_source(entry.path()) || others.contains(entry.path().extension().string())));
            if (!is_source(entry.path())) continue;
            for (const Include& include : includes_of(text_of(entry.path()))) {
                INFO(include.path);
                CHECK(include.is_plain);
                CHECK(fs::path(include.path).lexically_normal().string() == include.path);
                CHECK_FALSE(include.path.starts_with(".."));
                // A quoted path is looked for beside the file first.
                const fs::path beside = entry.path().parent_path() / include.path;
                CHECK_FALSE((include.is_quoted && fs::exists(beside)));
            }
        }
}

TEST_CASE("an include is found however it is written") {
    const auto path_of = [](const std::string& text) {
        const std::vector<Include> found = includes_of(text);
        return found.empty() ? std::string() : found.front().path;
    };
    CHECK(path_of("#include \"a/b.h\"") == "a/b.h");
    CHECK(path_of("  #  include <a/b.h> // why") == "a/b.h");
    CHECK(path_of("/* so */ #include /* or */ \"a/b.h\"\r\n") == "a/b.h");
    CHECK(path_of("%:include \"a/b.h\"") == "a/b.h");
    CHECK(path_of("#\\\nincl\\\nude \"a/b.h\"") == "a/b.h");
    CHECK(path_of("// #include \"a/b.h\"\n/*\n#include \"a/b.h\"\n*/").empty());
    CHECK(path_of("x = \"/*\";\n#include \"a/b.h\" // */") == "a/b.h");
    CHECK(includes_of("#include PATH").front().is_plain == false);
    CHECK(includes_of("#import \"a/b.h\"").front().is_plain == false);
    CHECK(includes_of("#include_next <b.h>").front().is_plain == false);
}

TEST_CASE("each folder of the driver is a layer") {
    const fs::path root = FFGPU_SOURCE_DIR;
    for_each_include(root, "driver", [](const std::string& path, const std::string&) {
        INFO(path);
        CHECK(Allowed.contains(folder_of(path)));
    });
}

TEST_CASE("a circle of any length is found") {
    const Arrows arrows{{"a", {"b"}}, {"b", {"c"}}, {"c", {"a", "d"}}, {"d", {"e"}}};
    CHECK(circle_of(arrows, "a") == std::set<std::string>{"b", "c"});
    CHECK(circle_of(arrows, "d").empty());
    CHECK(folder_of("driver/gl_types.h") == "driver");
    CHECK(folder_of("driver/trace/reader/call.h") == "driver/trace/reader");
    CHECK(folder_of("driver/window_system/turn.h") == "driver/window_system");
    CHECK(folder_of("model/device/registers/vertex.h") == "model/device/registers");
}

TEST_CASE("no two folders include each other, in circles of any length") {
    const fs::path root = FFGPU_SOURCE_DIR;
    Arrows arrows;
    for (const std::string& part : Parts) {
        for_each_include(root, part, [&](const std::string& path, const std::string& included) {
            const std::string from = folder_of(path), to = folder_of(included);
            if (from != to && fs::exists(root / included)) arrows[from].insert(to);
        });
    }
    REQUIRE(arrows.size() > 20);
    for (const auto& [folder, targets] : arrows) {
        const std::set<std::string> circle = circle_of(arrows, folder);
        std::string names;
        for (const std::string& other : circle)
            names += ' ' + other;
        INFO(folder << " is in a circle with" << names);
        CHECK(circle.empty());
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
