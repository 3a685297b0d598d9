// The two tables of stages: complete, called, and the only way to a stage.

#include "tests/gpu/busy_scene.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

// --- Tables with something planted ---------------------------------------------------------------

template <class Table>
const Table& scalar_table() {
    if constexpr (std::is_same_v<Table, Stages>)
        return ReferenceStages;
    else
        return ReferenceFragmentStages;
}

template <auto Member>
unsigned calls = 0;

// Puts a function there that counts its calls, and does the stage's work unless it is `idle`.
template <auto Member, bool Idle, class Table, class Result, class... Arguments>
void plant(Table& table, Result (*Table::*)(Arguments...)) {
    table.*Member = [](Arguments... arguments) -> Result {
        ++calls<Member>;
        if constexpr (Idle) {
            if constexpr (!std::is_void_v<Result>) return Result{};
        } else {
            return (scalar_table<Table>().*Member)(arguments...);
        }
    };
}

struct PlantedStages {
    Stages stages = ReferenceStages;
    FragmentStages fragment = ReferenceFragmentStages;

    PlantedStages() { stages.fragment = &fragment; }

    template <auto Member, bool Idle>
    void plant_at() {
        if constexpr (requires { fragment.*Member; })
            plant<Member, Idle>(fragment, Member);
        else
            plant<Member, Idle>(stages, Member);
    }
};

// Calls visit.template operator()<Member>() for each stage of both tables.
template <class Visit>
void for_each_stage(Visit&& visit) {
    visit.template operator()<&Stages::shade_vertices>();
    visit.template operator()<&Stages::set_up_triangles>();
    visit.template operator()<&Stages::cover_tile>();
    visit.template operator()<&Stages::cover_tile_samples>();
    visit.template operator()<&Stages::cover_windows>();
    visit.template operator()<&Stages::pack_quads>();
    visit.template operator()<&Stages::smooth_block>();
    visit.template operator()<&Stages::interpolate_depth>();
    visit.template operator()<&Stages::interpolate_sample_depths>();
    visit.template operator()<&Stages::interpolate_perspective>();
    visit.template operator()<&Stages::interpolate_colors>();
    visit.template operator()<&Stages::interpolate_tex_coords>();
    visit.template operator()<&Stages::interpolate_directions>();
    visit.template operator()<&Stages::sample>();
    static_assert(sizeof(Stages) == 16 * sizeof(void*),
                  "fourteen stages, the fragment's table, and what is passed over");
    visit.template operator()<&FragmentStages::run_environment>();
    visit.template operator()<&FragmentStages::add_secondary>();
    visit.template operator()<&FragmentStages::apply_fog>();
    visit.template operator()<&FragmentStages::apply_coverage>();
    visit.template operator()<&FragmentStages::alpha_test>();
    visit.template operator()<&FragmentStages::test_depth_target>();
    visit.template operator()<&FragmentStages::write_color>();
    static_assert(sizeof(FragmentStages) == 7 * sizeof(void*), "seven stages");
}

// --- Sources -------------------------------------------------------------------------------------

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// The functions on the right of the assignments in the table of that name.
std::set<std::string> functions_of_table(const std::string& source, const std::string& table) {
    std::set<std::string> names;
    const std::size_t begin = source.find(table + '{');
    const std::string body = source.substr(begin, source.find("};", begin) - begin);
    const std::regex assignment(R"(\.\w+ = (\w+),)");
    for (std::sregex_iterator i(body.begin(), body.end(), assignment), end; i != end; ++i)
        if ((*i)[1] != "true" && (*i)[1] != "false") names.insert((*i)[1]);
    return names;
}

} // namespace

TEST_CASE("The reference draws the busy scene as the fast forms do, for any threads and tiles") {
    const BusyPicture fast = draw_busy_scene({});
    CHECK(draw_busy_scene({.stages = &ReferenceStages}) == fast);
    CHECK(draw_busy_scene({.threads = 3, .tile_size = 16, .stages = &ReferenceStages}) == fast);
}

TEST_CASE("Each stage of the reference's table is called, and what it does is seen in the frame") {
    const BusyPicture whole = draw_busy_scene({});
    for_each_stage([&]<auto Member>() {
        PlantedStages planted;
        planted.plant_at<Member, false>();
        calls<Member> = 0;
        CHECK(draw_busy_scene({.stages = &planted.stages}) == whole);
        CHECK(calls<Member> > 0);
        planted.plant_at<Member, true>();
        INFO("a stage that does nothing is not noticed: " << __PRETTY_FUNCTION__);
        CHECK(draw_busy_scene({.stages = &planted.stages}) != whole);
    });
}

TEST_CASE("The two tables share no function") {
    for_each_stage([&]<auto Member>() {
        if constexpr (requires { FastStages.*Member; })
            CHECK(FastStages.*Member != ReferenceStages.*Member);
        else
            CHECK(FastFragmentStages.*Member != ReferenceFragmentStages.*Member);
    });
}

TEST_CASE("The files that run the pipe call no fast form by its name") {
    const fs::path model = fs::path(FFGPU_SOURCE_DIR) / "model";
    std::set<std::string> fast =
        functions_of_table(text_of(model / "gpu/stages.cpp"), "FastStages");
    REQUIRE(fast.size() == 14);
    fast.merge(
        functions_of_table(text_of(model / "fragment/fragment_stages.cpp"), "FastFragmentStages"));
    REQUIRE(fast.size() == 21);
    std::vector<fs::path> files{model / "fragment/fragment_pipe.cpp",
                                model / "fragment/sample_pipe.cpp"};
    for (const char* folder : {"gpu", "geometry"})
        for (const auto& entry : fs::directory_iterator(model / folder))
            if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    CHECK(files.size() > 20);
    for (const fs::path& file : files)
        for (const std::string& function : fast) {
            if (file.filename() == "vertex_stages_simd.cpp") continue; // It is one.
            // Not as a member, nor as a part of a longer name.
            const std::regex call("(^|[^\\w.>:])" + function + "\\(");
            INFO(file.string() << " calls " << function);
            CHECK_FALSE(std::regex_search(text_of(file), call));
        }
}
