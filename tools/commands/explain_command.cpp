#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/config/config_file.h"
#include "tools/config/settings_option.h"
#include "tools/explain/explain.h"
#include "tools/explain/footprint_picture.h"
#include "tools/explain/history_json.h"
#include "tools/explain/history_text.h"
#include "tools/explain/region_page.h"
#include "tools/files/files_to_write.h"
#include "tools/page/json_text.h"
#include "tools/record/recording_arguments.h"

#include <charconv>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr unsigned MostRegionPixels = 4096;

struct Arguments {
    ExplainOptions explain;
    std::string frame, pixel, region, output, footprint, config;
    std::vector<std::string> settings;
    bool lower_left = false, json = false;
};

// "12,34": as many numbers as wanted.
std::vector<unsigned> numbers(const std::string& option, const std::string& text, unsigned count) {
    std::vector<unsigned> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (values.size() < count) {
        unsigned value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc()) break;
        values.push_back(value);
        at = next;
        if (at == end || *at != ',' || values.size() == count) break;
        ++at;
    }
    if (values.size() != count || at != end)
        throw InputError(
            fmt::format("{} {}: expected {} numbers with commas between", option, text, count));
    return values;
}

std::uint64_t frame_number(const std::string& text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || next != end)
        throw InputError(
            fmt::format("--frame {}: expected a frame's number, counted from 0", text));
    return number;
}

void write_file(const std::string& path, const std::string& text) {
    WholeFile file(path);
    file.write(text);
    file.commit();
}

void explain_pixel(const Arguments& arguments, const ExplainedFrame& frame) {
    const auto at = numbers("--pixel", arguments.pixel, 2);
    if (arguments.lower_left && at[1] >= frame.height())
        throw InputError(
            fmt::format("--pixel {}: the picture has {} rows", arguments.pixel, frame.height()));
    const unsigned y = arguments.lower_left ? frame.height() - 1 - at[1] : at[1];
    const std::vector<PixelHistory> histories = frame.histories({{at[0], y}});
    const PixelHistory& history = histories.front();
    const std::string text =
        arguments.json ? json_text(history_json(history), 2) + '\n' : history_text(history);
    if (arguments.output.empty())
        std::fputs(text.c_str(), stdout);
    else
        write_file(arguments.output, text);
    if (arguments.footprint.empty()) return;
    const Image picture = footprint_picture(frame.tape(), history);
    if (picture.pixels() == 0)
        return warn("--footprint: no fragment of the pixel reads a texture: there is no picture");
    write_png(arguments.footprint, picture);
}

void explain_region(const Arguments& arguments, const ExplainedFrame& frame) {
    const auto at = numbers("--explain-region", arguments.region, 4);
    PageRegion region{{}, at[0], at[1], at[2], at[3]};
    const std::uint64_t count = std::uint64_t{region.width} * region.height;
    if (count == 0 || count > MostRegionPixels)
        throw InputError(fmt::format(
            "--explain-region {}: expected 1 to {} pixels", arguments.region, MostRegionPixels));
    if (std::uint64_t{region.x} + region.width > frame.width() ||
        std::uint64_t{region.y} + region.height > frame.height())
        throw InputError(fmt::format("--explain-region {}: the picture has {}x{} pixels",
                                     arguments.region,
                                     frame.width(),
                                     frame.height()));
    if (arguments.lower_left) region.y = frame.height() - region.y - region.height;
    region.title = fmt::format("{}, frame {}: {}x{} pixels from ({}, {})",
                               arguments.explain.input,
                               arguments.explain.frame,
                               region.width,
                               region.height,
                               region.x,
                               region.y);
    std::vector<PicturePixel> pixels;
    for (unsigned y = region.y; y < region.y + region.height; ++y)
        for (unsigned x = region.x; x < region.x + region.width; ++x)
            pixels.emplace_back(x, y);
    write_file(arguments.output, region_page(region, frame.histories(pixels)));
}

int run_explain(Arguments& arguments) {
    const bool has_region = !arguments.region.empty();
    if (has_region != arguments.pixel.empty())
        throw InputError("explain: expected --pixel X,Y or --explain-region X,Y,W,H");
    if (has_region && (arguments.output.empty() || arguments.json || !arguments.footprint.empty()))
        throw InputError("explain: --explain-region goes with -o PAGE.html, and with neither "
                         "--json nor --footprint");
    if (!has_region) numbers("--pixel", arguments.pixel, 2);
    ExplainOptions& options = arguments.explain;
    options.frame = frame_number(arguments.frame);
    check_files({arguments.explain.input, arguments.config},
                {{"-o", arguments.output}, {"--footprint", arguments.footprint}});
    if (!arguments.footprint.empty()) const WholeFile can_be_written(arguments.footprint);
    if (!arguments.config.empty()) read_config_file(arguments.config, options.configuration);
    for (const std::string& setting : arguments.settings)
        apply_setting(setting, options.configuration);
    options.warn = warn;
    const ExplainedFrame frame(options);
    if (has_region)
        explain_region(arguments, frame);
    else
        explain_pixel(arguments, frame);
    return 0;
}

} // namespace

void add_explain_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    ExplainOptions& options = arguments->explain;
    CLI::App* const verb = application.add_subcommand(
        "explain", "Tells the history of a pixel: each fragment and stage, test and texel");
    verb->add_option("input", options.input, "An apitrace file or a .ffc capture")->required();
    verb->add_option("--frame", arguments->frame, "The frame, counted from 0")
        ->type_name("F")
        ->required();
    verb->add_option("--pixel", arguments->pixel, "The pixel, from the picture's upper left")
        ->type_name("X,Y");
    verb->add_option("--explain-region", arguments->region, "Pixels for a page to click on")
        ->type_name("X,Y,W,H");
    verb->add_flag(
        "--lower-left", arguments->lower_left, "X,Y count from the lower left, as in GL");
    verb->add_option("-o,--output", arguments->output, "Write here, not to the terminal")
        ->type_name("FILE");
    verb->add_flag("--json", arguments->json, "As JSON");
    verb->add_option("--footprint", arguments->footprint, "Picture of the texels that were read")
        ->type_name("F.png");
    verb->add_flag("--timing", options.timing, "With hits, misses and cycles of the timing model");
    verb->add_option("--config", arguments->config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml|preset:NAME");
    add_settings_option(*verb, arguments->settings);
    add_samples_option(*verb, options.samples);
    add_swap_option(*verb, options.swap);
    verb->footer("Example: ffgpu explain traces/corridor.trace --frame 3 --pixel 160,200 --timing");
    verb->callback([arguments, &run] { run = [arguments] { return run_explain(*arguments); }; });
}

} // namespace ffgpu::tools
