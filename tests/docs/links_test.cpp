// The pages hang together: no link leads nowhere, and none is left out.

#include "tests/docs/text_file.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::docs {
namespace {

namespace fs = std::filesystem;

const fs::path Root = FFGPU_SOURCE_DIR;

std::vector<fs::path> pages() {
    std::vector<fs::path> all{Root / "README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(Root / "docs")) {
        if (entry.path().extension() == ".md") all.push_back(entry.path());
    }
    return all;
}

// The files that a page links to, without the place in them.
std::vector<fs::path> links(const fs::path& page) {
    const std::string text = read_source(fs::relative(page, Root).string());
    const std::regex link(R"(\]\(([^)#]+)(#[^)]*)?\))");
    std::vector<fs::path> all;
    for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i) {
        const std::string to = (*i)[1];
        if (to.find("://") == std::string::npos)
            all.push_back((page.parent_path() / to).lexically_normal());
    }
    return all;
}

} // namespace

TEST_CASE("every link of a page leads to a file") {
    for (const fs::path& page : pages()) {
        for (const fs::path& to : links(page)) {
            INFO(page << " links to " << to);
            CHECK(fs::exists(to));
        }
    }
}

TEST_CASE("every page is linked from another") {
    std::set<fs::path> linked;
    for (const fs::path& page : pages()) {
        for (const fs::path& to : links(page))
            if (to != page) linked.insert(to);
    }
    for (const fs::path& page : pages()) {
        if (page.filename() == "README.md") continue;
        INFO(page);
        CHECK(linked.count(page) == 1);
    }
}

} // namespace ffgpu::docs
