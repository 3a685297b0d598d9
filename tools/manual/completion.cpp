#include "tools/manual/completion.h"

#include "tools/files/shell_word.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

std::string verb_names(const ProgramText& program, const char* separator) {
    std::string names;
    for (const VerbText& verb : program.verbs)
        names += (names.empty() ? "" : separator) + verb.name;
    return names;
}

std::string option_names(const std::vector<OptionText>& options) {
    std::string names;
    for (const OptionText& option : options)
        if (!option.is_positional)
            names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(option.names, " "));
    return names;
}

// What stands for each of `special` in `text`.
std::string escaped(std::string text, std::string_view special, const std::string& before) {
    for (std::size_t at = 0; at < text.size(); at += before.size() + 1) {
        at = text.find_first_of(special, at);
        if (at == std::string::npos) break;
        text.insert(at, before);
    }
    return text;
}

std::string bash_values(const OptionText& option) {
    if (!option.choices.empty()) return fmt::format("-W \"{}\"", fmt::join(option.choices, " "));
    if (option.is_number()) return "-W \"\"";
    return option.is_folder() ? "-d" : "-f";
}

std::string bash_cases(const VerbText& verb) {
    std::string text;
    for (const OptionText& option : verb.options) {
        if (option.is_positional || option.value.empty()) continue;
        std::string names;
        for (const std::string& name : option.names)
            names += fmt::format("{}{}:{}", names.empty() ? "" : "|", verb.name, name);
        text += fmt::format("    {}) what=({}) ;;\n", names, bash_values(option));
    }
    return text;
}

// The verb's argument, where it is one of a few.
const OptionText* positional_choice(const VerbText& verb) {
    const auto found = std::ranges::find_if(verb.options, [](const OptionText& option) {
        return option.is_positional && !option.choices.empty();
    });
    return found == verb.options.end() ? nullptr : &*found;
}

} // namespace

std::string bash_completion(const ProgramText& program) {
    std::string text = fmt::format(R"(# Completions of ffgpu for bash, made from its options.
_ffgpu() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
  local verb= what i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${{COMP_WORDS[i]}} in
    --) what=(-c) ;;
    {}) verb=${{verb:-${{COMP_WORDS[i]}}}} ;;
    esac
  done
  case $verb in
  '') what=(-W "{} {}") ;;
)",
                                   verb_names(program, "|"),
                                   verb_names(program, " "),
                                   option_names(program.options));
    for (const VerbText& verb : program.verbs) {
        const OptionText* const choice = positional_choice(verb);
        text += fmt::format("  {}) {}[[ $current == -* ]] && what=(-W \"{}\") ;;\n",
                            verb.name,
                            choice ? "what=(" + bash_values(*choice) + "); " : "",
                            option_names(verb.options));
    }
    text += "  esac\n  case $verb:$previous in\n";
    for (const VerbText& verb : program.verbs)
        text += bash_cases(verb);
    return text + R"(  esac
  mapfile -t COMPREPLY < <(compgen "${what[@]:--f}" -- "$current")
  [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
  return 0
}
complete -o filenames -F _ffgpu ffgpu
)";
}

namespace {

std::string zsh_action(const OptionText& option) {
    if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
    if (option.is_number()) return " ";
    return option.is_folder() ? "_files -/" : "_files";
}

// One of _arguments' specifications for each name.
std::string zsh_specifications(const OptionText& option) {
    const std::string action =
        fmt::format(":{}:{}", escaped(option.value, ":", "\\"), zsh_action(option));
    if (option.is_positional) {
        const std::string name = escaped(option.names[0], ":", "\\");
        return fmt::format(" \\\n      {}",
                           shell_quoted(fmt::format("*:{}:{}", name, zsh_action(option))));
    }
    std::string text;
    for (const std::string& name : option.names)
        text += fmt::format(" \\\n      {}",
                            shell_quoted(fmt::format("*{}[{}]{}",
                                                     name,
                                                     escaped(option.description, "[]:\\", "\\"),
                                                     option.value.empty() ? "" : action)));
    return text;
}

} // namespace

std::string zsh_completion(const ProgramText& program) {
    std::string text = "#compdef ffgpu\n# Completions of ffgpu for zsh, made from its options.\n"
                       "_ffgpu() {\n  if (( CURRENT == 2 )); then\n    local -a verbs=(";
    for (const VerbText& verb : program.verbs)
        text += "\n      " + shell_quoted(verb.name + ':' + escaped(verb.description, ":", "\\"));
    text += ")\n    _describe 'verb' verbs\n    return\n  fi\n"
            "  local verb=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $verb in\n";
    for (const VerbText& verb : program.verbs) {
        text += fmt::format("  {})\n    _arguments -s", verb.name);
        for (const OptionText& option : verb.options)
            text += zsh_specifications(option);
        text += " ;;\n";
    }
    return text + "  esac\n}\n_ffgpu \"$@\"\n";
}

std::string fish_completion(const ProgramText& program) {
    std::string text = "# Completions of ffgpu for fish, made from its options.\n";
    for (const VerbText& verb : program.verbs) {
        text += fmt::format("complete -c ffgpu -n __fish_use_subcommand -f -a {} -d {}\n",
                            verb.name,
                            shell_quoted(verb.description));
        if (const OptionText* const choice = positional_choice(verb))
            text +=
                fmt::format("complete -c ffgpu -n '__fish_seen_subcommand_from {}' -f -a \"{}\"\n",
                            verb.name,
                            fmt::join(choice->choices, " "));
        for (const OptionText& option : verb.options) {
            if (option.is_positional) continue;
            text += fmt::format("complete -c ffgpu -n '__fish_seen_subcommand_from {}'", verb.name);
            for (const std::string& name : option.names)
                text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (!option.choices.empty())
                text += fmt::format(" -x -a \"{}\"", fmt::join(option.choices, " "));
            else if (option.is_folder())
                text += " -x -a '(__fish_complete_directories)'";
            else if (!option.value.empty())
                text += option.is_number() ? " -x" : " -r -F";
            text += " -d " + shell_quoted(option.description) + '\n';
        }
    }
    return text;
}

} // namespace ffgpu::tools
