#include "tools/cache/cache_arguments.h"

#include "model/base/input_error.h"
#include "tools/config/config_file.h"
#include "tools/config/nearest_name.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::uint32_t LeastLine = 16, MostLine = 512;

template <class Choice, std::size_t N>
Choice
choice(const char* option, const std::string& text, const std::array<std::string_view, N>& names) {
    for (std::size_t i = 0; i < N; ++i)
        if (text == names[i]) return static_cast<Choice>(i);
    throw InputError(fmt::format("{} {}: expected {}; did you mean '{}'?",
                                 option,
                                 text,
                                 fmt::join(names, ", "),
                                 nearest_name(text, {names.begin(), names.end()})));
}

// A number up to the text's end, or to `until`, which it is cut off with.
std::optional<std::uint32_t> take_number(std::string_view& text, char until) {
    const std::string_view part = text.substr(0, text.find(until));
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    return number;
}

// "tiled:16"
RasterChoice parse_order(const std::string& text, std::uint32_t configured_width) {
    const std::size_t colon = text.find(':');
    RasterChoice order{
        choice<work::Traversal>("--order", text.substr(0, colon), work::TraversalNames),
        configured_width};
    if (colon == std::string::npos) return order;
    if (order.traversal == work::Traversal::Scanline || order.traversal == work::Traversal::Column)
        throw InputError(fmt::format("--order {}: expected no width: it has no tiles", text));
    std::string_view rest = std::string_view(text).substr(colon + 1);
    const auto width = take_number(rest, '\0');
    if (!width || *width < 2 || *width > 512 || !std::has_single_bit(*width))
        throw InputError(
            fmt::format("--order {}: expected a tile's width, a power of two from 2 to 512", text));
    order.tile_width = *width;
    return order;
}

// Of values that were given twice the first ones: each is a curve of its own.
template <class Value>
void drop_repeats(std::vector<Value>& values) {
    for (auto value = values.begin(); value != values.end();)
        value = std::find(values.begin(), value, *value) == value ? value + 1 : values.erase(value);
}

// Without --line those of the lines that are looked at otherwise which are as long as the first
// level's, or that one.
void fit_lines(const CacheGeometry& first_level, std::vector<std::uint32_t>& line_bytes) {
    std::erase_if(line_bytes, [&](std::uint32_t line) { return line < first_level.line_bytes; });
    if (line_bytes.empty()) line_bytes.push_back(first_level.line_bytes);
}

void check_power(const char* option, std::uint32_t value, std::uint32_t least, std::uint32_t most) {
    if (value < least || value > most || !std::has_single_bit(value))
        throw InputError(fmt::format(
            "{} {}: expected a power of two from {} to {}", option, value, least, most));
}

} // namespace

work::LookupClient parse_client(const char* option, const std::string& text) {
    return choice<work::LookupClient>(option, text, work::LookupClientNames);
}

CacheGeometry parse_geometry(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const auto sets = take_number(rest, 'x'), ways = take_number(rest, 'x'),
               line = take_number(rest, 'x');
    if (!sets || !ways || !line || !rest.empty())
        throw InputError(
            fmt::format("{} {}: expected SETSxWAYSxBYTES of a line, like 64x4x64", option, text));
    check_power(option.c_str(), *sets, 1, 1u << 20);
    check_power(option.c_str(), *line, LeastLine, MostLine);
    if (*ways < 1 || *ways > 1u << 16)
        throw InputError(fmt::format("{} {}: expected 1 to 65536 ways", option, text));
    return {*sets, *ways, *line};
}

void add_cache_options(CLI::App& verb, CacheArguments& arguments) {
    verb.add_option("input", arguments.input, "A trace, a .ffc capture or a work file (.ffw)")
        ->required();
    verb.add_option("-o,--output", arguments.output, "Folder for curves.csv, working_sets.csv")
        ->type_name("DIR");
    const auto list = [&](const char* name, auto& value, const char* meaning, const char* type) {
        verb.add_option(name, value, meaning)
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name(type);
    };
    list("--client", arguments.clients, "texel, depth, color, vertex", "CLIENT[,CLIENT]");
    list("--line", arguments.line_bytes, "Bytes of a line: 32,64,128", "BYTES[,BYTES]");
    list("--layout", arguments.layouts, "Of images: linear, blocked, blocked_6d", "NAME[,NAME]");
    list("--order", arguments.orders, "Raster orders: scanline,tiled:8", "NAME[:WIDTH][,NAME]");
    verb.add_option("--most-sets", arguments.most_sets, "Follow caches of 1, 2, 4 ... N sets")
        ->type_name("N");
    verb.add_option("--most-ways", arguments.most_ways, "and of 1, 2, 3 ... N ways")
        ->type_name("N");
    verb.add_flag("--unmerged", arguments.unmerged, "Each texel that a quad reads is a look-up");
    verb.add_option("--first-level", arguments.first_level, "Curves of the texel caches behind it")
        ->type_name("SETSxWAYSxBYTES");
    verb.add_option("--miss-map", arguments.miss_map, "Pictures of where this texel cache misses")
        ->type_name("SETSxWAYSxBYTES");
    verb.add_option("--frames", arguments.frames, "Only these frames of a trace")
        ->type_name("A-B")
        ->each(check_frame_range);
    verb.add_option("--config", arguments.config, "Parameters; ffgpu config prints them")
        ->type_name("F.toml|preset:NAME");
    verb.add_option("--set", arguments.settings, "Change a parameter: raster.granularity=fragment")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

CacheStudyOptions resolve(const CacheArguments& arguments) {
    CacheStudyOptions options;
    Configuration& configuration = options.configuration;
    options.input = arguments.input;
    if (!arguments.config.empty()) read_config_file(arguments.config, configuration);
    for (const std::string& setting : arguments.settings)
        apply_setting(setting, configuration);
    if (!arguments.frames.empty()) options.frames = parse_frame_range(arguments.frames);
    if (!arguments.clients.empty()) options.clients.clear();
    for (const std::string& name : arguments.clients)
        options.clients.push_back(parse_client("--client", name));
    for (const std::string& name : arguments.layouts)
        options.layouts.push_back(choice<work::Layout>("--layout", name, work::LayoutNames));
    for (const std::string& order : arguments.orders)
        options.orders.push_back(parse_order(order, configuration.timing.raster.tile_width));
    if (!arguments.line_bytes.empty()) options.line_bytes = arguments.line_bytes;
    drop_repeats(options.clients);
    drop_repeats(options.layouts);
    drop_repeats(options.orders);
    drop_repeats(options.line_bytes);
    for (const std::uint32_t line_bytes : options.line_bytes)
        check_power("--line", line_bytes, LeastLine, MostLine);
    check_power("--most-sets", arguments.most_sets, 1, 1u << 16);
    if (arguments.most_ways < 1 || arguments.most_ways > 1024)
        throw InputError(fmt::format("--most-ways {}: expected 1 to 1024", arguments.most_ways));
    options.most_sets = arguments.most_sets;
    options.most_ways = arguments.most_ways;
    options.merges = !arguments.unmerged;
    if (!arguments.first_level.empty())
        options.first_level = parse_geometry("--first-level", arguments.first_level);
    const auto& clients = options.clients;
    if (options.first_level &&
        std::find(clients.begin(), clients.end(), work::LookupClient::Texel) == clients.end())
        throw InputError("--first-level: it is of texels; expected texel among --client, too");
    if (options.first_level && arguments.line_bytes.empty())
        fit_lines(*options.first_level, options.line_bytes);
    if (arguments.miss_map.empty()) return options;
    if (arguments.output.empty()) throw InputError("--miss-map: expected -o DIR, too");
    options.miss_map = parse_geometry("--miss-map", arguments.miss_map);
    return options;
}

} // namespace ffgpu::tools
