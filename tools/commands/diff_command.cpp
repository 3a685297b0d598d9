#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/diff/backend.h"
#include "tools/diff/difference_text.h"
#include "tools/record/recording_arguments.h"
#include "tools/rtl/rtl_comparison.h"
#include "tools/rtl/wave_range.h"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Arguments {
    DiffOptions diff;
    std::string input_b, frames, parts;
    std::optional<std::string> backend_b;
    std::string fst, fst_cycles;
    bool account = false;
};

std::string side_text(const AccountSide& side) {
    const std::string program = side.program.empty() ? "" : ", drawn by " + side.program;
    return side.input + ", " + side.backend + program;
}

// What another build asks this one for.
int run_account(const Arguments& arguments) {
    const AccountSide& side = arguments.diff.a;
    const Backend backend(side.backend);
    write_account(side.input, backend.stages(), arguments.diff.question, stdout);
    return 0;
}

// What B's units in RTL do up to the end of the command that differs, drawn once more: the unit
// that is the first to part from the model, and waves.
void tell_units(const Arguments& arguments, const rtl::WaveCycles& cycles, std::uint64_t command) {
    const DiffOptions& options = arguments.diff;
    const Backend backend(options.b.backend, arguments.fst, cycles);
    draw_up_to(options.b.input, backend.stages(), options.question, command);
    if (const auto unit = backend.rtl()->take_difference())
        fmt::print("First of B's units to part from the model: {}\n", stage_text(*unit));
    if (!arguments.fst.empty())
        fmt::print("Waves, which end with command {}: {}\n", command, arguments.fst);
}

int run_diff(Arguments& arguments) {
    DiffOptions& options = arguments.diff;
    AccountQuestion& question = options.question;
    if (!arguments.frames.empty()) question.frames = parse_frame_range(arguments.frames);
    if (question.command) question.parts = AccountParts(arguments.parts);
    if (arguments.account) return run_account(arguments);
    if (options.most_entries == 0) throw InputError("--most 0: expected at least 1");
    options.b.input = arguments.input_b.empty() ? options.a.input : arguments.input_b;
    const rtl::WaveCycles cycles = parse_wave_cycles(arguments.fst_cycles);
    const bool same_input = options.b.input == options.a.input;
    const bool other_program = options.a.program != options.b.program;
    options.b.backend = arguments.backend_b.value_or(
        same_input && !other_program ? "reference" : options.a.backend);
    const bool has_units = options.b.backend.starts_with("rtl") && options.b.program.empty();
    if (!arguments.fst.empty() && !has_units)
        throw InputError("--fst: B is drawn by no unit in RTL (--backend-b rtl:UNIT)");
    fmt::print("A: {}\nB: {}\n", side_text(options.a), side_text(options.b));
    const auto difference = find_difference(options);
    if (!difference) {
        fmt::print("Equal: every command, stage, fragment and target{}\n",
                   question.command ? fmt::format(" of command {}", *question.command) : "");
        return 0;
    }
    fmt::print("{}", difference_text(options, *difference));
    if (has_units) tell_units(arguments, cycles, difference->command);
    return 1;
}

} // namespace

void add_diff_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    DiffOptions& options = arguments->diff;
    CLI::App* const verb = application.add_subcommand(
        "diff", "Names the first draw, stage, quad, lane and field in which two backends part");
    verb->add_option("a", options.a.input, "An apitrace file or a .ffc capture")->required();
    verb->add_option("b", arguments->input_b, "The other side's; the same if there is none");
    verb->add_option("--backend-a",
                     options.a.backend,
                     "functional (default), reference, rtl or rtl:UNIT,UNIT")
        ->type_name("NAME");
    verb->add_option("--backend-b",
                     arguments->backend_b,
                     "By default reference, or A's where inputs or programs differ")
        ->type_name("NAME");
    verb->add_option("--program-a", options.a.program, "Another build's ffgpu, which draws A")
        ->type_name("PROGRAM");
    verb->add_option("--program-b", options.b.program, "Another build's ffgpu, which draws B")
        ->type_name("PROGRAM");
    verb->add_option("--frames", arguments->frames, "3-7, 3 or 3-: compare these frames alone")
        ->type_name("RANGE")
        ->each(check_frame_range);
    verb->add_option("--command", options.question.command, "Compare this command alone")
        ->type_name("N")
        ->each([](const std::string& text) {
            if (text.starts_with('-'))
                throw InputError("--command " + text + ": expected the number of a command");
        });
    verb->add_option("--most", options.most_entries, "Entries of that command to tell (default 1)")
        ->type_name("N");
    CLI::Option* const fst =
        verb->add_option("--fst", arguments->fst, "Waves of B's units in RTL: FOLDER/UNIT.fst")
            ->type_name("FOLDER");
    verb->add_option("--fst-cycles", arguments->fst_cycles, "Of these cycles of each unit's alone")
        ->needs(fst)
        ->type_name("RANGE");
    add_samples_option(*verb, options.question.samples);
    add_swap_option(*verb, options.question.swap);
    // For the other side's program.
    verb->add_flag("--account", arguments->account)->group("");
    verb->add_option("--parts", arguments->parts)->group("");
    verb->footer("Example: ffgpu diff traces/corridor.trace --frames 0-2\n"
                 "Exit status: 0 equal, 1 they differ, 2 bad input.");
    verb->callback([arguments, &run] { run = [arguments] { return run_diff(*arguments); }; });
}

} // namespace ffgpu::tools
