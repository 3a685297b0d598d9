#include "tools/page/page.h"

#include "model/base/check.h"
#include "tools/page/assets.h"

namespace ffgpu::tools {
namespace {

// Nothing is fetched, whatever the page holds.
constexpr std::string_view Head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<link rel="icon" href="data:,">
)";

std::string_view known_asset(std::string_view name) {
    const std::string_view text = asset(name);
    check(!text.empty(), "a page's file is not in the program");
    return text;
}

// JSON within HTML: nothing in it may end the script.
std::string without_tags(std::string_view json) {
    std::string text;
    text.reserve(json.size());
    for (const char character : json) {
        if (character == '<')
            text += "\\u003c";
        else
            text += character;
    }
    return text;
}

void add_script(std::string& html, std::string_view name) {
    html.append("<script>\n").append(known_asset(name)).append("</script>\n");
}

} // namespace

std::string escaped(std::string_view text) {
    std::string html;
    for (const char character : text) {
        if (character == '<')
            html += "&lt;";
        else if (character == '&')
            html += "&amp;";
        else if (character == '"')
            html += "&quot;";
        else
            html += character;
    }
    return html;
}

std::string html_of(const Page& page) {
    std::string html(Head);
    html += "<title>" + escaped(page.title) + "</title>\n<style>\n";
    html += known_asset("page.css");
    for (const std::string_view name : page.css)
        html += known_asset(name);
    html += "</style>\n</head>\n<body>\n" + page.body;
    html += R"(<script type="application/json" id="data">)" + without_tags(page.data);
    html += "</script>\n";
    add_script(html, "theme.js");
    for (const std::string_view name : page.code)
        add_script(html, name);
    return html + "</body>\n</html>\n";
}

} // namespace ffgpu::tools
