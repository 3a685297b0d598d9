#include "tools/config/config_file.h"

#include "model/base/input_error.h"
#include "tools/config/config_text.h"
#include "tools/config/nearest_name.h"
#include "tools/config/preset.h"
#include "tools/config/toml_file.h"

#include <bit>
#include <cctype>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::string place(const std::string& source, const toml::node& node) {
    const toml::source_position at = node.source().begin;
    const bool is_option = source.starts_with("--"); // which has no lines
    return at.line == 0 || is_option ? source : fmt::format("{}:{}", source, at.line);
}

std::string choices(const ParameterInfo& info) {
    return fmt::format("\"{}\"", fmt::join(info.choices, "\", \""));
}

std::string range(const ParameterInfo& info) {
    if (!info.choices.empty()) return choices(info);
    return fmt::format("{}{} to {}{}",
                       info.or_zero ? "0, or " : "",
                       info.minimum,
                       info.maximum,
                       info.power_of_two ? ", a power of two" : "");
}

template <class Field>
void set_number(Field& field,
                const toml::node& node,
                const ParameterInfo& info,
                const std::string& where) {
    const auto* const value = node.as_integer();
    if (!value) throw InputError(fmt::format("{}: expected an integer, {}", where, range(info)));
    const std::int64_t number = value->get();
    const bool in_range =
        number >= info.minimum && number <= info.maximum &&
        (!info.power_of_two || std::has_single_bit(static_cast<std::uint64_t>(number)));
    if (!in_range && !(info.or_zero && number == 0))
        throw InputError(fmt::format("{}: expected {}, found {}", where, range(info), number));
    field = static_cast<Field>(number);
}

template <class Field>
void set_choice(Field& field,
                const toml::node& node,
                const ParameterInfo& info,
                const std::string& where) {
    const auto* const value = node.as_string();
    for (std::size_t i = 0; value && i < info.choices.size(); ++i) {
        if (value->get() != info.choices[i]) continue;
        field = static_cast<Field>(i);
        return;
    }
    throw InputError(fmt::format("{}: expected one of {}{}",
                                 where,
                                 choices(info),
                                 value ? ", found \"" + value->get() + "\"" : ""));
}

template <class Field>
void set_field(Field& field,
               const toml::node& node,
               const ParameterInfo& info,
               const std::string& where) {
    if constexpr (std::is_same_v<Field, bool>) {
        if (const auto* const value = node.as_boolean()) {
            field = value->get();
            return;
        }
        const auto* const word = node.as_string();
        if (!word || (word->get() != "on" && word->get() != "off"))
            throw InputError(where + ": expected true or false, or on or off");
        field = word->get() == "on";
    } else if constexpr (std::is_enum_v<Field>) {
        set_choice(field, node, info, where);
    } else {
        set_number(field, node, info, where);
    }
}

// A group's `profile` sets others of its fields, so it comes before what the table says of them.
template <class Group>
void apply_profile(Group& group,
                   std::string_view group_name,
                   const toml::table& table,
                   const std::string& source) {
    if constexpr (requires { group.apply_profile(); }) {
        const toml::node* const node = table.get("profile");
        if (!node) return;
        Group::visit(group, [&](std::string_view name, auto& field, const ParameterInfo& info) {
            if (name != "profile") return;
            set_field(field,
                      *node,
                      info,
                      fmt::format("{}: {}.profile", place(source, *node), group_name));
        });
        group.apply_profile();
    }
}

template <class Group>
void set_group(Group& group,
               std::string_view group_name,
               const toml::table& table,
               const std::string& source) {
    apply_profile(group, group_name, table, source);
    for (const auto& entry : table) {
        const toml::key& key = entry.first; // No bindings: clang 14's lambdas cannot name them.
        const toml::node& node = entry.second;
        bool found = false;
        std::vector<std::string> names;
        const std::string path = fmt::format("{}.{}", group_name, key.str());
        Group::visit(group, [&](std::string_view name, auto& field, const ParameterInfo& info) {
            names.push_back(fmt::format("{}.{}", group_name, name));
            if (name != key.str()) return;
            found = true;
            set_field(field, node, info, place(source, node) + ": " + path);
        });
        if (!found)
            throw InputError(fmt::format("{}: unknown parameter {}; did you mean {}?",
                                         place(source, node),
                                         path,
                                         nearest_name(path, names)));
    }
}

void apply(const toml::table& tables, const std::string& source, Configuration& configuration) {
    for (const auto& entry : tables) {
        const toml::key& key = entry.first; // No bindings: clang 14's lambdas cannot name them.
        const toml::node& node = entry.second;
        bool found = false;
        std::vector<std::string> names;
        Configuration::visit(configuration, [&](std::string_view name, auto& group) {
            names.emplace_back(name);
            if (name != key.str()) return;
            found = true;
            if (!node.is_table())
                throw InputError(
                    fmt::format("{}: {} is a table of parameters", place(source, node), key.str()));
            set_group(group, name, *node.as_table(), source);
        });
        if (!found)
            throw InputError(fmt::format("{}: unknown table {}; did you mean {}?",
                                         place(source, node),
                                         key.str(),
                                         nearest_name(key.str(), names)));
    }
}

// raster.traversal=scanline -> raster.traversal="scanline": a shell takes TOML's quotes away.
std::string quote_choice(const std::string& setting) {
    const std::size_t value = setting.find_first_not_of(" =", setting.find('='));
    if (value == std::string::npos || !std::islower(static_cast<unsigned char>(setting[value])))
        return setting;
    const std::string_view word = std::string_view(setting).substr(value);
    if (word == "true" || word == "false") return setting;
    return fmt::format("{}\"{}\"", setting.substr(0, value), word);
}

bool is_toml(const std::string& text) {
    try {
        parse_toml(text, "");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

// What is no value of TOML's becomes a text, so that the parameter says what it expects.
std::string quote_unknown(const std::string& setting) {
    if (is_toml(setting)) return setting;
    const std::size_t value = setting.find('=') + 1;
    return fmt::format("{}'''{}'''", setting.substr(0, value), setting.substr(value));
}

template <class Field>
std::string written(const Field& field, const ParameterInfo& info) {
    if constexpr (std::is_same_v<Field, bool>) {
        return field ? "true" : "false";
    } else if constexpr (std::is_enum_v<Field>) {
        return fmt::format("\"{}\"", info.choices[static_cast<std::size_t>(field)]);
    } else {
        return std::to_string(field);
    }
}

} // namespace

void read_config_file(const std::string& path, Configuration& configuration) {
    if (is_preset(path)) return apply_preset(path, configuration);
    apply(read_toml_file(path), path, configuration);
}

void apply_text(const std::string& text, const std::string& source, Configuration& configuration) {
    apply(parse_toml(text, source), source, configuration);
}

void apply_setting(const std::string& setting,
                   Configuration& configuration,
                   const std::string& option) {
    const std::size_t equals = setting.find('=');
    const bool has_both = setting.find_first_not_of(' ') < equals && equals < setting.size() &&
                          setting.find_first_not_of(' ', equals + 1) < setting.size();
    if (!has_both) throw InputError(fmt::format("{} {}: expected NAME=VALUE", option, setting));
    apply_text(quote_unknown(quote_choice(setting)), option, configuration);
}

std::map<std::string, std::string> parameter_values(const Configuration& configuration) {
    std::map<std::string, std::string> values;
    Configuration::visit(configuration, [&](std::string_view group_name, const auto& group) {
        std::remove_cvref_t<decltype(group)>::visit(
            group, [&](std::string_view name, const auto& field, const ParameterInfo& info) {
                values[fmt::format("{}.{}", group_name, name)] = written(field, info);
            });
    });
    return values;
}

std::string to_toml(const Configuration& configuration) {
    std::string text = "# ffgpu's configuration. Each line: the parameter; its unit, range, "
                       "meaning.\n";
    Configuration::visit(configuration, [&](std::string_view group_name, const auto& group) {
        text += fmt::format("\n[{}]\n", group_name);
        std::remove_cvref_t<decltype(group)>::visit(
            group, [&](std::string_view name, const auto& field, const ParameterInfo& info) {
                const std::string line = fmt::format("{} = {}", name, written(field, info));
                const std::string unit = info.unit.empty() ? "" : fmt::format("{}, ", info.unit);
                const std::string values =
                    std::is_same_v<std::remove_cvref_t<decltype(field)>, bool> ? "true or false"
                                                                               : range(info);
                text += fmt::format("{:<32} # {}{}: {}\n", line, unit, values, info.meaning);
            });
    });
    return text;
}

} // namespace ffgpu::tools
