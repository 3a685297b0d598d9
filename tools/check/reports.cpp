#include "tools/check/reports.h"

#include "tools/page/page.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// Within one line.
std::string escaped_line(std::string text) {
    std::ranges::replace_if(
        text, [](char character) { return static_cast<unsigned char>(character) < ' '; }, ' ');
    return escaped(text);
}

// A file's path as a page's address (RFC 3986): a name may hold '#', '?', '%' or any byte.
std::string address(const std::string& path) {
    std::string text;
    for (const char character : path) {
        const auto byte = static_cast<unsigned char>(character);
        const bool stands_for_itself =
            (byte < 0x80 && std::isalnum(byte)) ||
            std::string_view("/-._~").find(character) != std::string_view::npos;
        text += stands_for_itself ? std::string(1, character) : fmt::format("%{:02X}", byte);
    }
    return text;
}

std::size_t count_of(const std::vector<CheckedFrame>& frames, Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(frames, verdict, &CheckedFrame::verdict));
}

std::string junit_case(const CheckedFrame& frame) {
    const std::string head = fmt::format(R"(    <testcase classname="{}" name="{}")",
                                         escaped_line(frame.trace),
                                         escaped_line(frame.name));
    if (frame.verdict == Verdict::Passed) return head + "/>\n";
    const char* const kind = frame.verdict == Verdict::Failed ? "failure" : "error";
    // Jenkins shows the attribute, GitLab the element's text alone.
    return fmt::format("{0}>\n      <{1} message=\"{2}\">{2}</{1}>\n    </testcase>\n",
                       head,
                       kind,
                       escaped_line(frame.message));
}

constexpr const char* PageHead = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{0}</title>
<style>
body {{ font: 14px sans-serif; margin: 1em; background: #fff; color: #111 }}
table {{ border-collapse: collapse }}
td, th {{ padding: 2px 10px; text-align: left; border-bottom: 1px solid #ccc }}
h1, h2, p, td {{ overflow-wrap: anywhere }}
.Failed, .Error {{ color: #b00 }}
figure {{ display: inline-block; margin: 0 1em 1em 0 }}
img {{ max-width: 30vw; image-rendering: pixelated; border: 1px solid #ccc }}
@media (max-width: 40em) {{
  figure {{ display: block; margin-right: 0 }}
  img {{ max-width: 100%; box-sizing: border-box }}
  td, th {{ padding: 2px 4px }}
}}
</style>
<h1>{0}</h1>
<p>{1} passed, {2} failed, {3} errors.</p>
)";

const char* name_of(Verdict verdict) {
    if (verdict == Verdict::Passed) return "Passed";
    return verdict == Verdict::Failed ? "Failed" : "Error";
}

std::string figure(const std::string& file, const char* caption) {
    if (file.empty()) return "";
    return fmt::format(
        "<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n",
        address(file),
        caption);
}

} // namespace

std::string junit_report(const std::string& suite, const std::vector<CheckedFrame>& frames) {
    std::string text =
        fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                    "<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                    escaped_line(suite),
                    frames.size(),
                    count_of(frames, Verdict::Failed),
                    count_of(frames, Verdict::Error));
    for (auto begin = frames.begin(); begin != frames.end();) {
        const auto end = std::find_if(
            begin, frames.end(), [&](const auto& frame) { return frame.trace != begin->trace; });
        const std::vector<CheckedFrame> trace(begin, end);
        text +=
            fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                        escaped_line(begin->trace),
                        trace.size(),
                        count_of(trace, Verdict::Failed),
                        count_of(trace, Verdict::Error));
        for (const CheckedFrame& frame : trace)
            text += junit_case(frame);
        text += "  </testsuite>\n";
        begin = end;
    }
    return text + "</testsuites>\n";
}

std::string html_report(const std::string& suite, const std::vector<CheckedFrame>& frames) {
    std::string text = fmt::format(fmt::runtime(PageHead),
                                   escaped_line(suite),
                                   count_of(frames, Verdict::Passed),
                                   count_of(frames, Verdict::Failed),
                                   count_of(frames, Verdict::Error));
    for (const CheckedFrame& frame : frames) {
        if (frame.verdict == Verdict::Passed) continue;
        text += fmt::format("<h2>{} {}</h2>\n<p class=\"{}\">{}</p>\n",
                            escaped_line(frame.trace),
                            escaped_line(frame.name),
                            name_of(frame.verdict),
                            escaped_line(frame.message));
        text += figure(frame.picture, "drawn") + figure(frame.reference, "reference") +
                figure(frame.difference_picture, "difference, times 8");
    }
    text += "<h2>All</h2>\n<table>\n<tr><th>trace<th>frame<th>result<th>\n";
    for (const CheckedFrame& frame : frames)
        text += fmt::format("<tr><td>{}<td>{}<td class=\"{}\">{}<td>{}\n",
                            escaped_line(frame.trace),
                            escaped_line(frame.name),
                            name_of(frame.verdict),
                            name_of(frame.verdict),
                            escaped_line(frame.message));
    return text + "</table>\n</html>\n";
}

} // namespace ffgpu::tools
