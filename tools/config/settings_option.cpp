#include "tools/config/settings_option.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

constexpr const char* Option = "--set";

bool is_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::islower(c) || std::isdigit(c) || c == '_';
    });
}

// texel_cache.ways=8
bool is_setting(std::string_view word) {
    const std::string_view path = word.substr(0, word.find_first_of(" ="));
    const std::size_t dot = path.find('.');
    return word.find('=') != std::string_view::npos && dot != std::string_view::npos &&
           is_name(path.substr(0, dot)) && is_name(path.substr(dot + 1));
}

} // namespace

void add_settings_option(CLI::App& verb, std::vector<std::string>& settings) {
    verb.add_option(Option, settings, "Change parameters: texel_cache.ways=8 raster.tile_width=4")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false); // spread_settings() gives each its own.
}

std::vector<std::string> spread_settings(const std::vector<std::string>& words) {
    std::vector<std::string> spread;
    bool in_settings = false, has_one = false;
    for (auto word = words.begin(); word != words.end(); ++word) {
        if (*word == "--") {
            spread.insert(spread.end(), word, words.end());
            break;
        }
        const bool is_option = *word == Option;
        const bool goes_with = in_settings && !is_option && (!has_one || is_setting(*word));
        if (goes_with && has_one) spread.emplace_back(Option);
        has_one = goes_with;
        in_settings = is_option || goes_with;
        spread.push_back(*word);
    }
    return spread;
}

} // namespace ffgpu::tools
