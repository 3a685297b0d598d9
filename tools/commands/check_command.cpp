#include "model/base/whole_file.h"
#include "tools/check/check_suite.h"
#include "tools/check/reports.h"
#include "tools/commands/commands.h"
#include "tools/commands/warn.h"
#include "tools/files/files_to_write.h"
#include "tools/replay/interruption.h"
#include "tools/report/statistics_file.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Arguments {
    std::string suite, junit;
    CheckOptions check;
};

void write_text(const std::string& path, const std::string& text) {
    WholeFile file(path);
    file.write(text);
    file.commit();
}

void tell(const CheckedFrame& frame) {
    const char* const verdict = frame.verdict == Verdict::Passed   ? "pass "
                                : frame.verdict == Verdict::Failed ? "FAIL "
                                                                   : "ERROR";
    fmt::print("{} {} {}: {}\n", verdict, frame.trace, frame.name, frame.message);
}

int run_check(Arguments& arguments) {
    const Suite suite = read_suite(arguments.suite);
    check_files({arguments.suite}, {{"--junit", arguments.junit}});
    const std::filesystem::path output = arguments.check.output;
    make_folder(output.string());
    arguments.check.on_frame = tell;
    arguments.check.warn = warn;
    const Interruption interruption;
    const std::vector<CheckedFrame> frames = check_suite(suite, arguments.check);
    write_text((output / "index.html").string(), html_report(suite.name, frames));
    if (arguments.junit.empty()) arguments.junit = (output / "junit.xml").string();
    write_text(arguments.junit, junit_report(suite.name, frames));
    const auto passed = std::ranges::count(frames, Verdict::Passed, &CheckedFrame::verdict);
    fmt::print("{} of {} pass; {}\n", passed, frames.size(), (output / "index.html").string());
    return Interruption::status(passed == std::ssize(frames) ? 0 : 1);
}

} // namespace

void add_check_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const verb = application.add_subcommand(
        "check", "Draws a suite of traces and compares their frames with references");
    verb->add_option("suite", arguments->suite, "Traces, frames, references, tolerances (TOML)")
        ->required();
    verb->add_option("-o,--output", arguments->check.output, "Folder for pictures and reports")
        ->type_name("DIR")
        ->required();
    verb->add_option("--junit", arguments->junit, "JUnit's XML; junit.xml in DIR otherwise")
        ->type_name("FILE.xml");
    verb->add_flag("--update", arguments->check.update, "What is drawn becomes the reference");
    verb->footer("Example: ffgpu check suite.toml -o out/check");
    verb->callback([arguments, &run] { run = [arguments] { return run_check(*arguments); }; });
}

} // namespace ffgpu::tools
