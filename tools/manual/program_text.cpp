#include "tools/manual/program_text.h"

#include "tools/config/configuration.h"
#include "tools/heatmap/heat_map.h"
#include "tools/views/view.h"

#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

// "MODE:{copy,exchange}" -> copy, exchange; CLI11 writes a check for membership so.
std::vector<std::string> members(const std::string& type) {
    std::vector<std::string> list;
    const std::size_t begin = type.find('{'), end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos) return list;
    std::istringstream text(type.substr(begin + 1, end - begin - 1));
    for (std::string member; std::getline(text, member, ',');)
        list.push_back(member);
    return list;
}

std::vector<std::string> parameter_assignments() {
    std::vector<std::string> names;
    const Configuration configuration;
    Configuration::visit(configuration, [&](std::string_view group_name, const auto& group) {
        std::remove_cvref_t<decltype(group)>::visit(
            group, [&](std::string_view name, const auto&, const ParameterInfo&) {
                names.push_back(std::string(group_name) + '.' + std::string(name) + '=');
            });
    });
    return names;
}

std::vector<std::string> choices_of(const std::string& type) {
    if (type == "NAME=VALUE") return parameter_assignments();
    if (type.starts_with("VIEW")) {
        std::string names = view_names();
        std::erase(names, ' ');
        return members('{' + names + '}');
    }
    if (!type.starts_with("MAP")) return members(type);
    std::vector<std::string> names;
    names.reserve(HeatMapTable.size());
    for (const HeatMapInfo& map : HeatMapTable)
        names.emplace_back(map.name);
    return names;
}

OptionText text_of(const CLI::Option& option) {
    OptionText text;
    text.is_positional = option.get_positional();
    if (text.is_positional) {
        text.names.push_back(option.get_name(true));
    } else {
        for (const std::string& name : option.get_snames())
            text.names.push_back('-' + name);
        for (const std::string& name : option.get_lnames())
            text.names.push_back("--" + name);
    }
    if (option.get_type_size_max() > 0) {
        const std::string type = option.get_type_name();
        text.value = type.substr(0, type.find(':'));
        text.choices = choices_of(type);
    }
    text.description = option.get_description();
    text.is_required = option.get_required();
    return text;
}

std::vector<OptionText> options_of(const CLI::App& application) {
    std::vector<OptionText> options;
    for (const CLI::Option* const option : application.get_options())
        options.push_back(text_of(*option));
    return options;
}

} // namespace

ProgramText program_text(const CLI::App& application) {
    ProgramText program{.description = application.get_description(),
                        .footer = application.get_footer(),
                        .version = application.version(),
                        .options = options_of(application),
                        .verbs = {}};
    for (const CLI::App* const verb :
         application.get_subcommands([](const CLI::App*) { return true; }))
        program.verbs.push_back(
            {verb->get_name(), verb->get_description(), verb->get_footer(), options_of(*verb)});
    std::vector<std::string> names;
    for (const VerbText& verb : program.verbs)
        names.push_back(verb.name);
    for (VerbText& verb : program.verbs)
        for (OptionText& option : verb.options)
            if (option.value == "VERB") option.choices = names;
    return program;
}

} // namespace ffgpu::tools
