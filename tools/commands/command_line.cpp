#include "tools/commands/command_line.h"

#include "model/base/input_error.h"
#include "model/timing/machine_stuck.h"
#include "tools/commands/commands.h"
#include "tools/commands/sweep_command.h"
#include "tools/commands/warn.h"
#include "tools/config/nearest_name.h"
#include "tools/config/settings_option.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

constexpr int Done = 0, BadInput = 2;

constexpr const char* Program = "program"; // that is run, with its arguments, which may be empty

int fail(const char* message, int status = BadInput) {
    std::fprintf(stderr, "ffgpu: %s\n", message);
    return status;
}

// A first word that is no verb: CLI11 would only say that one is missing.
void check_verb(const CLI::App& application, const char* word) {
    if (word[0] == '-') return;
    std::vector<std::string> verbs;
    for (const CLI::App* const verb : application.get_subcommands({}))
        verbs.push_back(verb->get_name());
    if (std::find(verbs.begin(), verbs.end(), word) == verbs.end())
        throw InputError("there is no verb '" + std::string(word) + "'; did you mean '" +
                         nearest_name(word, verbs) + "'? (ffgpu --help lists the verbs)");
}

// CLI11 counts the "--" before a program among what it did not expect.
std::string unexpected(const CLI::ExtrasError& error) {
    std::string text = error.what();
    const std::size_t dashes = text.find(": -- ");
    if (dashes != std::string::npos) text.erase(dashes + 2, 3);
    return text;
}

// CLI11 names what is missing first; what it did not understand is why.
std::string missing(const CLI::App& application, const CLI::RequiredError& error) {
    for (const CLI::App* const verb : application.get_subcommands())
        for (const std::string& word : verb->remaining())
            if (word.size() > 1 && word[0] == '-' && word != "--")
                return "The following argument was not expected: " + word;
    return error.what();
}

// An empty value is a name that was not set, and never meant as none.
void refuse_empty_values(CLI::App& application) {
    const CLI::Validator is_given(
        [](std::string& value) { return std::string(value.empty() ? "expected a value" : ""); },
        "");
    for (CLI::App* const verb : application.get_subcommands({}))
        for (CLI::Option* const option : verb->get_options())
            if (option->get_items_expected_max() > 0 && option->get_name() != Program)
                option->check(is_given);
}

void parse(CLI::App& application, int count, const char* const* arguments) {
    const auto words = spread_settings({arguments + 1, arguments + count});
    application.parse(std::vector(words.rbegin(), words.rend())); // It takes them from the end.
}

// All that was printed has to have arrived.
int checked_output(int status) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    return fail("standard output: cannot be written");
}

} // namespace

int status_of(const std::function<int()>& work) {
    try {
        return work();
    } catch (const InputError& error) {
        return fail(error.what());
    } catch (const timing::MachineStuck& stuck) {
        return fail(stuck.what(), timing::StuckStatus);
    } catch (const std::bad_alloc&) {
        return fail(OutOfMemory);
    } catch (const std::system_error& error) { // Of a folder or a file, with its path.
        return fail(error.what());
    } catch (const nlohmann::json::exception& error) { // A path that is not UTF-8, where JSON is.
        return fail(error.what());
    }
}

int run_command_line(int count, const char* const* arguments, const char* version) {
    CLI::App application("ffgpu: a deterministic emulator of a fixed-function GPU", "ffgpu");
    application.set_version_flag("--version", std::string("ffgpu ") + version);
    application.require_subcommand(1);
    application.footer(
        "Each verb has --help with an example: ffgpu replay --help\n"
        "Exit status: 0 done, 1 a comparison failed, 2 bad input or usage, 3 the timed machine "
        "is stuck.");
    Run run;
    add_replay_command(application, run);
    add_run_command(application, run);
    add_time_command(application, run);
    add_report_command(application, run);
    add_cache_command(application, run);
    add_compare_command(application, run);
    add_check_command(application, run);
    add_diff_command(application, run);
    add_config_command(application, run);
    add_info_command(application, run);
    add_dump_command(application, run);
    add_explain_command(application, run);
    add_export_command(application, run);
    add_completion_command(application, run);
    add_manual_command(application, run);
    add_presets_command(application, run);
    add_sweep_command(application, run, version);
    refuse_empty_values(application);
    const auto parse_and_run = [&] {
        if (count > 1) check_verb(application, arguments[1]);
        parse(application, count, arguments);
        return checked_output(run());
    };
    try {
        return status_of(parse_and_run);
    } catch (const CLI::ExtrasError& error) {
        return fail((unexpected(error) + " (ffgpu --help lists the verbs)").c_str());
    } catch (const CLI::RequiredError& error) {
        return fail((missing(application, error) + " (ffgpu --help lists the verbs)").c_str());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == Done) // --help, --version
            return checked_output(application.exit(error));
        return fail((std::string(error.what()) + " (ffgpu --help lists the verbs)").c_str());
    }
}

} // namespace ffgpu::tools
