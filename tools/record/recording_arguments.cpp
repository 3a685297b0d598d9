#include "tools/record/recording_arguments.h"

#include "model/base/input_error.h"
#include "model/device/layout/limits.h"
#include "tools/config/config_file.h"
#include "tools/config/preset.h"
#include "tools/config/settings_option.h"
#include "tools/files/files_to_write.h"

#include <filesystem>
#include <fstream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

constexpr unsigned MaxHeatTile = 4096;
constexpr unsigned MaxSteps = 1'000'000;

// The names of the file's members, each with the argument.
template <class Arguments, class Visitor>
void visit_members(Arguments& arguments, Visitor&& member) {
    member("output", arguments.output);
    member("frames", arguments.frames);
    member("heat_maps", arguments.heat_maps);
    member("heat_scale", arguments.heat_scale);
    member("heat_tile", arguments.heat_tile);
    member("heat_blend", arguments.heat_blend);
    member("heat_raw", arguments.heat_raw);
    member("views", arguments.views);
    member("draws", arguments.draws);
    member("steps", arguments.steps);
    member("draw_table", arguments.draw_table);
    member("draw_pixels", arguments.draw_pixels);
    member("capture", arguments.capture);
    member("save_work", arguments.save_work);
    member("work_values", arguments.work_values);
    member("config", arguments.config);
    member("settings", arguments.settings);
    member("timing", arguments.timing);
    member("no_images", arguments.no_images);
    member("reference", arguments.reference);
}

void make_absolute(std::string& path) {
    if (!path.empty()) path = std::filesystem::absolute(path).string();
}

void add_heat_map_options(CLI::App& verb, RecordingArguments& arguments) {
    verb.add_option("--heatmap", arguments.heat_maps, heat_map_names())->type_name("MAP[,MAP]");
    verb.add_option(
            "--heatmap-scale", arguments.heat_scale, "White: N, or all but the largest in 200")
        ->type_name("auto|N");
    verb.add_option("--heatmap-tile", arguments.heat_tile, "Means over squares of N pixels")
        ->type_name("N")
        ->check(CLI::Range(1u, MaxHeatTile));
    verb.add_flag("--heatmap-blend", arguments.heat_blend, "Heat maps over the frame");
    verb.add_flag("--heatmap-npy", arguments.heat_raw, "Their numbers, too: heat_MAP_0000.npy ...");
}

void add_draw_options(CLI::App& verb, RecordingArguments& arguments) {
    verb.add_option("--view", arguments.views, view_names())->type_name("VIEW[,VIEW]");
    verb.add_option("--draws", arguments.draws, "Draw only these, as stats.json numbers them")
        ->type_name("A-B")
        ->each([](const std::string& text) { parse_frame_range(text, "--draws"); });
    verb.add_option("--steps", arguments.steps, "A picture behind each N-th draw of a frame")
        ->type_name("N")
        ->check(CLI::Range(1u, MaxSteps));
    verb.add_flag("--per-draw", arguments.draw_table, "draws.csv: a line a draw, clear and copy");
    verb.add_flag("--draw-pixels", arguments.draw_pixels, "draw_pixels.csv: where each draw is");
}

void resolve_heat_maps(const RecordingArguments& arguments, HeatMapOptions& heat) {
    if (!arguments.heat_maps.empty()) heat.maps = parse_heat_maps(arguments.heat_maps);
    if (!arguments.heat_scale.empty()) heat.full_scale = parse_heat_scale(arguments.heat_scale);
    heat.tile = arguments.heat_tile;
    heat.blend = arguments.heat_blend;
    heat.raw = arguments.heat_raw;
}

void resolve_draws(const RecordingArguments& arguments, RecordingOptions& options) {
    WantedViews wanted = parse_views(arguments.views);
    options.views = wanted.views;
    options.heat.maps.merge(wanted.heat_maps);
    const bool colors = !arguments.heat_scale.empty() || arguments.heat_tile != 1 ||
                        arguments.heat_blend || arguments.heat_raw;
    if (colors && options.heat.maps.empty())
        throw InputError("--heatmap-scale, -tile, -blend and -npy go with --heatmap MAP");
    if (!arguments.draws.empty()) options.draws = parse_frame_range(arguments.draws, "--draws");
    options.steps = arguments.steps;
    options.draw_table = arguments.draw_table;
    options.draw_pixels = arguments.draw_pixels;
    const bool shows =
        !options.views.empty() || options.steps > 0 || options.draw_table || options.draw_pixels;
    if (shows && arguments.output.empty())
        throw InputError("--view, --steps, --per-draw and --draw-pixels need -o DIR");
}

// What is no UTF-8, as names of files may be, is no text to JSON: it stands there as its bytes.
nlohmann::ordered_json member(const std::string& text) {
    using Json = nlohmann::ordered_json;
    const Json member = text;
    try {
        static_cast<void>(member.dump());
        return member;
    } catch (const nlohmann::json::type_error&) {
        return std::vector<unsigned char>(text.begin(), text.end());
    }
}

template <class Value>
const Value& member(const Value& value) {
    return value;
}

void take(const nlohmann::json& member, std::string& text) {
    if (!member.is_array()) return static_cast<void>(member.get_to(text));
    const auto bytes = member.get<std::vector<unsigned char>>();
    text.assign(bytes.begin(), bytes.end());
}

template <class Value>
void take(const nlohmann::json& member, Value& value) {
    member.get_to(value);
}

} // namespace

bool RecordingArguments::any() const {
    return !output.empty() || !capture.empty() || !save_work.empty() || !config.empty() ||
           !settings.empty() || !frames.empty() || !heat_maps.empty() || threads || timing ||
           no_images || reference || work_values || !views.empty() || !draws.empty() || steps > 0 ||
           draw_table || draw_pixels;
}

void add_recording_options(CLI::App& verb, RecordingArguments& arguments) {
    verb.add_option("-o,--output", arguments.output, "Folder for frame_0000.png ..., stats.json")
        ->type_name("DIR");
    verb.add_option("--frames", arguments.frames, "Write and measure only these frames")
        ->type_name("A-B")
        ->each(check_frame_range);
    verb.add_option("--config", arguments.config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml|preset:NAME");
    add_settings_option(verb, arguments.settings);
    verb.add_option("--threads", arguments.threads, "Threads that draw (gpu.threads)")
        ->type_name("N");
    verb.add_flag("--timing", arguments.timing, "Run the timing model: cycles, caches, memory");
    add_heat_map_options(verb, arguments);
    add_draw_options(verb, arguments);
    verb.add_option("--capture", arguments.capture, "Write the frames as a device capture")
        ->type_name("FILE.ffc");
    verb.add_option("--save-work", arguments.save_work, "Keep the work of the frames: ffgpu time")
        ->type_name("FILE.ffw");
    verb.add_flag(
        "--work-values", arguments.work_values, "Keep depths and colours in the work, too");
    verb.add_flag("--no-images", arguments.no_images, "Write no frame_*.png");
    verb.add_flag("--reference", arguments.reference, "Draw with the scalar specifications: slow");
}

void add_samples_option(CLI::App& verb, unsigned& samples) {
    verb.add_option("--samples", samples, "4: multisample every window")
        ->type_name("N")
        ->check(CLI::IsMember({1u, MaxSamples}));
}

void add_swap_option(CLI::App& verb, gl::SwapMode& swap) {
    const std::map<std::string, gl::SwapMode> modes{{"copy", gl::SwapMode::Copy},
                                                    {"exchange", gl::SwapMode::Exchange}};
    verb.add_option_function<std::string>(
            "--swap",
            [&swap, modes](const std::string& mode) { swap = modes.at(mode); },
            "copy: a swap keeps the back buffer; exchange: it then has the picture before the last")
        ->type_name("MODE")
        ->check(CLI::IsMember({"copy", "exchange"}));
}

void resolve(const RecordingArguments& arguments, RecordingOptions& options) {
    check_files({arguments.config},
                {{"--capture", arguments.capture}, {"--save-work", arguments.save_work}});
    if (!arguments.config.empty()) read_config_file(arguments.config, options.configuration);
    for (const std::string& setting : arguments.settings)
        apply_setting(setting, options.configuration);
    if (arguments.threads)
        apply_setting("gpu.threads=" + std::to_string(*arguments.threads),
                      options.configuration,
                      "--threads");
    if (!arguments.frames.empty()) options.frames = parse_frame_range(arguments.frames);
    resolve_heat_maps(arguments, options.heat);
    resolve_draws(arguments, options);
    options.output = arguments.output;
    options.capture = arguments.capture;
    options.save_work = arguments.save_work;
    options.work_values = arguments.work_values;
    options.timing = arguments.timing;
    options.images = !arguments.no_images;
    options.reference = arguments.reference;
}

std::string settings_without_effect(const RecordingArguments& arguments) {
    if (arguments.timing) return {};
    std::vector<std::string> settings;
    for (const std::string& setting : arguments.settings)
        if (setting.find(GpuParameters::Name) != setting.find_first_not_of(" \t"))
            settings.push_back(setting);
    return fmt::format("{}", fmt::join(settings, ", "));
}

std::string to_json(RecordingArguments arguments) {
    make_absolute(arguments.output);
    make_absolute(arguments.capture);
    make_absolute(arguments.save_work);
    if (!is_preset(arguments.config)) make_absolute(arguments.config);
    if (arguments.threads)
        arguments.settings.push_back("gpu.threads=" + std::to_string(*arguments.threads));
    nlohmann::ordered_json file;
    visit_members(arguments,
                  [&](const char* name, const auto& value) { file[name] = member(value); });
    return file.dump(2) + '\n';
}

RecordingArguments read_recording_arguments(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw InputError(path + ": cannot be read");
    RecordingArguments arguments;
    try {
        const auto members = nlohmann::json::parse(file);
        visit_members(arguments, [&](const char* name, auto& value) {
            if (members.contains(name)) take(members.at(name), value);
        });
    } catch (const nlohmann::json::exception& error) {
        throw InputError(path + ": is no file of recording options: " + error.what());
    }
    return arguments;
}

} // namespace ffgpu::tools
