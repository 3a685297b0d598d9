#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/manual/completion.h"
#include "tools/manual/man_page.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

namespace ffgpu::tools {
namespace {

std::string completion(const ProgramText& program, const std::string& shell) {
    if (shell == "bash") return bash_completion(program);
    return shell == "zsh" ? zsh_completion(program) : fish_completion(program);
}

std::string manual(const ProgramText& program, const std::string& name) {
    if (name.empty()) return man_page(program);
    const auto verb = std::ranges::find(program.verbs, name, &VerbText::name);
    if (verb == program.verbs.end()) throw InputError("manual: there is no verb '" + name + "'");
    return man_page(program, *verb);
}

} // namespace

void add_completion_command(CLI::App& application, Run& run) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* const verb =
        application.add_subcommand("completion", "Prints the completions of options for a shell");
    verb->add_option("shell", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    verb->footer("Example: eval \"$(ffgpu completion bash)\"");
    verb->callback([shell, &application, &run] {
        run = [shell, &application] {
            std::fputs(completion(program_text(application), *shell).c_str(), stdout);
            return 0;
        };
    });
}

void add_manual_command(CLI::App& application, Run& run) {
    const auto name = std::make_shared<std::string>();
    CLI::App* const verb =
        application.add_subcommand("manual", "Prints the manual page of ffgpu or of a verb");
    verb->add_option("verb", *name, "The verb; without it: of ffgpu")->type_name("VERB");
    verb->footer("Example: ffgpu manual replay | man -l -");
    verb->callback([name, &application, &run] {
        run = [name, &application] {
            std::fputs(manual(program_text(application), *name).c_str(), stdout);
            return 0;
        };
    });
}

} // namespace ffgpu::tools
