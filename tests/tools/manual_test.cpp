// Completions and manual pages, judged by the programs that read them: shells and groff.

#include "tests/support/temporary_file.h"
#include "tests/tools/tool.h"

#include <cstdlib>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

std::string output_of(const std::vector<std::string>& arguments) {
    return printed(stdout, [&] { CHECK(run(arguments) == 0); });
}

// What the command prints on both streams.
std::string shell(const std::string& command) {
    std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        text += static_cast<char>(c);
    ::pclose(pipe);
    return text;
}

bool is_there(const std::string& program) {
    const bool found = std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
    if (!found) WARN(program + " is not installed: what is for it is not read");
    return found;
}

TEST_CASE("bash completes verbs, options and values") {
    const TemporaryFile script(output_of({"completion", "bash"}), ".sh");
    const auto completed = [&](const std::string& words, int last) {
        return shell("cd " FFGPU_SOURCE_DIR "; bash -c 'source " + script.path() +
                     "; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(last) +
                     "; _ffgpu; echo \"${COMPREPLY[@]}\"'");
    };
    CHECK(completed("ffgpu repl", 1) == "replay\n");
    CHECK(completed("ffgpu --ver", 1) == "--version\n");
    CHECK(completed("ffgpu replay --sw", 2) == "--swap\n");
    CHECK(completed("ffgpu replay --swap \"\"", 3) == "copy exchange\n");
    CHECK(completed("ffgpu run --samples \"\"", 3) == "1 4\n");
    CHECK(completed("ffgpu run --heatmap over", 3) == "overdraw\n");
    CHECK(completed("ffgpu time --set texel_cache.wa", 3) == "texel_cache.ways=\n");
    CHECK(completed("ffgpu replay -o tool", 3) == "tools\n");       // a folder
    CHECK(completed("ffgpu replay README", 2) == "README.md\n");    // a file
    CHECK(completed("ffgpu replay -o README", 3) == "\n");          // no folder
    CHECK(completed("ffgpu compare --sw", 2) == "\n");              // another verb's
    CHECK_THAT(completed("ffgpu run -- bas", 3), Contains("bash")); // a program
    CHECK(completed("ffgpu completion \"\"", 2) == "bash zsh fish\n");
    CHECK(completed("ffgpu manual repl", 2) == "replay\n");
}

TEST_CASE("zsh and fish understand what is for them") {
    const TemporaryFile zsh(output_of({"completion", "zsh"}), "_ffgpu");
    if (is_there("zsh")) CHECK(shell("zsh -n " + zsh.path()).empty());
    const TemporaryFile fish(output_of({"completion", "fish"}), ".fish");
    if (!is_there("fish")) return;
    CHECK(shell("fish --no-execute " + fish.path()).empty());
    const auto completed = [&](const std::string& line) {
        return shell("HOME=/nonexistent fish --no-config -c 'source " + fish.path() +
                     "; complete -C \"" + line + "\"'");
    };
    CHECK_THAT(completed("ffgpu rep"), Contains("replay\t"));
    CHECK_THAT(completed("ffgpu replay --sw"), Contains("--swap\t"));
    CHECK_THAT(completed("ffgpu replay --swap "), Contains("copy") && Contains("exchange"));
    CHECK_THAT(completed("ffgpu compare --sw"), !Contains("--swap"));
    CHECK(completed("ffgpu completion ") == "bash\nfish\nzsh\n");
    CHECK(completed("ffgpu manual repl") == "replay\n");
    CHECK(run({"completion", "tcsh"}) == 2);
}

TEST_CASE("manual pages are read without a complaint and hold every option") {
    if (!is_there("groff")) return;
    for (const std::string verb : {"",
                                   "replay",
                                   "run",
                                   "compare",
                                   "config",
                                   "time",
                                   "info",
                                   "dump",
                                   "explain",
                                   "report",
                                   "presets"}) {
        INFO(verb);
        const TemporaryFile page(output_of(verb.empty() ? std::vector<std::string>{"manual"}
                                                        : std::vector<std::string>{"manual", verb}),
                                 ".1");
        CHECK(shell("groff -man -ww -Tutf8 -z " + page.path()).empty());
        const std::string text = shell("groff -man -Tascii -P-cbou " + page.path());
        // CLI11's own help is the list to compare with.
        std::istringstream help(output_of(verb.empty() ? std::vector<std::string>{"--help"}
                                                       : std::vector<std::string>{verb, "--help"}));
        for (std::string word; help >> word;) {
            if (!word.starts_with("--") || word.size() < 4) continue;
            const std::string option = word.substr(0, word.find_first_of(",:="));
            CHECK_THAT(text, Contains(option));
        }
    }
    CHECK(run({"manual", "fly"}) == 2);
}

} // namespace
} // namespace ffgpu::tools
