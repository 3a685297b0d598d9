#include "tools/diff/difference_text.h"

#include "tools/files/shell_word.h"

#include <cstdio>
#include <iterator>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

struct Pixel {
    unsigned x = 0, y = 0; // from the lower left
};

// Of an entry of a fragment or a target's pixel.
std::optional<Pixel> pixel_of(const DifferentEntry& entry) {
    unsigned primitive = 0, piece = 0, x = 0, y = 0, lane = 0;
    const char* const place = entry.place.c_str();
    const char* const fragment = "primitive %u piece %u quad %u,%u lane %u";
    if (std::sscanf(place, fragment, &primitive, &piece, &x, &y, &lane) == 5)
        return Pixel{x + lane % 2, y + lane / 2};
    if (std::sscanf(place, "pixel %u,%u", &x, &y) == 2) return Pixel{x, y};
    return std::nullopt;
}

std::string entry_text(const DifferentEntry& entry) {
    std::string text = fmt::format("  stage    {}\n  place    {}", entry.part, entry.place);
    if (const auto pixel = pixel_of(entry); pixel && entry.place.starts_with("primitive"))
        text += fmt::format(" (pixel {},{} from the lower left)", pixel->x, pixel->y);
    if (!entry.field.empty()) text += "\n  field    " + entry.field;
    return text + fmt::format("\n  A        {}\n  B        {}\n", entry.a, entry.b);
}

std::string side_words(const DiffOptions& options) {
    const AccountSide &a = options.a, &b = options.b;
    std::string words = shell_word(a.input);
    if (b.input != a.input) words += ' ' + shell_word(b.input);
    words += " --backend-a " + a.backend + " --backend-b " + b.backend;
    if (!a.program.empty()) words += " --program-a " + shell_word(a.program);
    if (!b.program.empty()) words += " --program-b " + shell_word(b.program);
    if (options.question.samples > 1)
        words += fmt::format(" --samples {}", options.question.samples);
    if (options.question.swap == gl::SwapMode::Exchange) words += " --swap exchange";
    return words;
}

} // namespace

std::string difference_text(const DiffOptions& options, const Difference& difference) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "Command {}", difference.command);
    if (!difference.name.empty()) {
        fmt::format_to(out, " ({}), frame {}", difference.name, difference.frame);
        if (difference.draw != "-") fmt::format_to(out, ", draw {}", difference.draw);
        if (difference.call_name != "-")
            fmt::format_to(out, ", call {} {}", difference.call, difference.call_name);
        text += ": the first that differs";
    }
    text += '\n';
    for (const DifferentEntry& entry : difference.entries)
        text += entry_text(entry);
    if (difference.parts.size() > 1)
        fmt::format_to(out, "Differ in this command: {}\n", fmt::join(difference.parts, ", "));
    if (difference.name.empty()) return text;
    fmt::format_to(out,
                   "Again: ffgpu diff {} --command {} --most 20\n",
                   side_words(options),
                   difference.command);
    const auto pixel =
        difference.entries.empty() ? std::nullopt : pixel_of(difference.entries.front());
    if (pixel)
        fmt::format_to(out,
                       "       ffgpu explain {} --frame {} --pixel {},{} --lower-left\n",
                       shell_word(options.a.input),
                       difference.frame,
                       pixel->x,
                       pixel->y);
    return text;
}

} // namespace ffgpu::tools
