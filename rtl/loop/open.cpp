// The stages of chosen units as a table, and the library's one door.

#include "rtl/bundles/waves.h"
#include "rtl/loop/loop_log.h"
#include "rtl/loop/loop_stages.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ffgpu::rtl {
namespace {

using namespace std::string_view_literals;

// In the order of the pipe.
constexpr std::array Units{"tile_walker"sv,
                           "depth_plane"sv,
                           "attribute_plane"sv,
                           "reciprocal"sv,
                           "perspective"sv,
                           "level_of_detail"sv,
                           "texel_address"sv,
                           "texel_decode"sv,
                           "filter_tree"sv,
                           "texture_environment"sv,
                           "color_sum"sv,
                           "fog"sv,
                           "apply_coverage"sv,
                           "alpha_test"sv,
                           "stencil_depth"sv,
                           "blend"sv};

class Loop final : public RtlStages {
public:
    explicit Loop(const LoopOptions& options)
        : options_(options) {
        loop_log() = {};
        loop_log().fault = options.fault;
        loop_log().waves = options.waves;
        loop_log().wave_cycles = options.wave_cycles;
        choose_texture_units();
        choose_raster_units();
        choose_fragment_units();
        table_.fragment = &fragment_;
        table_.packs_kept_colors = false; // which no unit would see
    }

    const Stages& table() const override { return table_; }
    std::vector<StageShare> shares() const override {
        std::vector<StageShare> shares;
        for (const auto& [key, fragments] : loop_log().fragments)
            shares.push_back({key.first, key.second, fragments});
        return shares;
    }
    std::optional<StageDifference> take_difference() override {
        return std::exchange(loop_log().difference, std::nullopt);
    }

private:
    bool has(std::string_view unit) const {
        return std::ranges::any_of(
            options_.units, [&](const std::string& name) { return name == unit || name == "all"; });
    }
    void choose_texture_units() {
        if (!has("level_of_detail") && !has("texel_address") && !has("texel_decode") &&
            !has("filter_tree"))
            return;
        table_.interpolate_tex_coords = make_tex_coords;
        table_.interpolate_directions = make_directions;
        table_.sample = sample;
    }
    void choose_raster_units() {
        if (has("tile_walker")) {
            table_.cover_tile = cover_tile;
            table_.cover_windows = cover_windows;
            table_.cover_tile_samples = cover_tile_samples;
            table_.smooth_block = smooth_block;
        }
        if (has("depth_plane")) {
            table_.interpolate_depth = interpolate_depth;
            table_.interpolate_sample_depths = interpolate_sample_depths;
        }
        if (has("attribute_plane") || has("reciprocal") || has("perspective")) {
            table_.interpolate_perspective = interpolate_perspective;
            table_.interpolate_colors = interpolate_colors;
            table_.interpolate_tex_coords = interpolate_tex_coords;
            table_.interpolate_directions = interpolate_directions;
        }
    }
    void choose_fragment_units() {
        if (has("texture_environment")) fragment_.run_environment = run_environment;
        if (has("color_sum")) fragment_.add_secondary = add_secondary;
        if (has("fog")) fragment_.apply_fog = apply_fog;
        if (has("apply_coverage")) fragment_.apply_coverage = apply_coverage;
        if (has("alpha_test")) fragment_.alpha_test = alpha_test;
        if (has("stencil_depth")) fragment_.test_depth_target = test_depth_target;
        if (has("blend")) fragment_.write_color = write_color;
    }

    LoopOptions options_;
    FragmentStages fragment_ = FastFragmentStages;
    Stages table_ = FastStages;
};

bool is_unit(const std::string& name) {
    return name == "all" || std::ranges::find(Units, name) != Units.end();
}

// Empty: nothing.
std::string what_is_wrong_with(const LoopOptions& options) {
    const auto unknown = std::ranges::find_if_not(options.units, is_unit);
    if (unknown == options.units.end() && !options.units.empty()) return {};
    const bool names_none = unknown == options.units.end() || unknown->empty();
    std::string why =
        "--rtl: " + (names_none ? "no unit is named" : "there is no unit " + *unknown);
    why += "; there are all";
    for (const std::string_view unit : Units)
        why.append(", ").append(unit);
    if (!options.other_names.empty()) why += ", " + options.other_names;
    return why;
}

} // namespace
} // namespace ffgpu::rtl

extern "C" __attribute__((visibility("default"))) ffgpu::rtl::RtlStages*
ffgpu_open_rtl_stages(const ffgpu::rtl::LoopOptions& options, std::string& why) {
    using namespace ffgpu::rtl;
    if (!options.waves.empty() && !CanWriteWaves) {
        why = NoWaves;
        return nullptr;
    }
    why = what_is_wrong_with(options);
    if (!why.empty()) return nullptr;
    return new Loop(options);
}
