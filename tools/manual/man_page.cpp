#include "tools/manual/man_page.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// A dash is one that can be copied, a backslash is itself, and no line begins as a request.
std::string troff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool at_start = result.empty() || result.back() == '\n';
        if (at_start && (c == '.' || c == '\'')) result += "\\&";
        result += c == '-'    ? std::string("\\-")
                  : c == '\\' ? std::string("\\e")
                              : std::string(1, c);
    }
    return result;
}

std::string upper(std::string text) {
    std::ranges::transform(
        text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string title(const ProgramText& program, const std::string& name) {
    return fmt::format(
        ".TH {} 1 \"\" \"{}\" \"User Commands\"\n", troff(upper(name)), troff(program.version));
}

std::string synopsis(const VerbText& verb) {
    std::string text = fmt::format(".SH SYNOPSIS\n.B ffgpu {}\n[options]", verb.name);
    for (const OptionText& option : verb.options)
        if (option.is_positional)
            text += option.is_required ? fmt::format(" \\fI{}\\fR", troff(option.names[0]))
                                       : fmt::format(" [\\fI{}\\fR]", troff(option.names[0]));
    return text + '\n';
}

std::string describe(const OptionText& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\f{}{}\\fR",
                             names.empty() ? "" : ", ",
                             option.is_positional ? 'I' : 'B',
                             troff(name));
    if (!option.value.empty() && !option.is_positional)
        names += fmt::format(" \\fI{}\\fR", troff(option.value));
    return fmt::format(".TP\n{}\n{}\n", names, troff(option.description));
}

// The lines of a footer, each its own.
std::string lines(const std::string& footer) {
    std::istringstream text(footer);
    std::string result;
    for (std::string line; std::getline(text, line);)
        result += troff(line) + "\n.br\n";
    return result;
}

} // namespace

std::string man_page(const ProgramText& program) {
    std::string text =
        title(program, "ffgpu") +
        fmt::format(".SH NAME\nffgpu \\- {}\n",
                    troff(program.description.substr(program.description.find(": ") + 2))) +
        ".SH SYNOPSIS\n.B ffgpu\n\\fIverb\\fR [options]\n.SH VERBS\n";
    for (const VerbText& verb : program.verbs)
        text += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBffgpu\\-{}\\fR(1)\n",
                            verb.name,
                            troff(verb.description),
                            verb.name);
    text += ".SH OPTIONS\n";
    for (const OptionText& option : program.options)
        text += describe(option);
    return text + ".SH NOTES\n" + lines(program.footer);
}

std::string man_page(const ProgramText& program, const VerbText& verb) {
    std::string text =
        title(program, "ffgpu-" + verb.name) +
        fmt::format(".SH NAME\nffgpu\\-{} \\- {}\n", verb.name, troff(verb.description)) +
        synopsis(verb) + ".SH OPTIONS\n";
    for (const OptionText& option : verb.options)
        text += describe(option);
    return text + ".SH NOTES\n" + lines(verb.footer) + ".SH SEE ALSO\n\\fBffgpu\\fR(1)\n";
}

} // namespace ffgpu::tools
