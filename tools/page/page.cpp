#include "tools/page/page.h"

#include "model/base/check.h"
#include "tools/page/assets.h"

#include <algorithm>
#include <array>
#include <bit>

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

// Of the character that the text begins with; 0: it is none that XML allows (its section 2.2), in
// UTF-8 (RFC 3629).
std::size_t character_bytes(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const unsigned first = byte(0);
    if (first < 0x80)
        return first >= ' ' || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
    constexpr std::array<unsigned, 5> Least{0, 0, 0x80, 0x800, 0x10000}; // by length
    const auto length =
        static_cast<std::size_t>(std::countl_one(static_cast<unsigned char>(first)));
    if (length < 2 || length > 4) return 0;
    unsigned code = first & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    const bool is_surrogate = code >= 0xD800 && code < 0xE000;
    const bool is_allowed = code >= Least[length] && code <= 0x10FFFF && !is_surrogate &&
                            code != 0xFFFE && code != 0xFFFF;
    return is_allowed ? length : 0;
}

// Empty: the character stands for itself.
std::string_view entity(char character) {
    switch (character) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    default:
        return {};
    }
}

} // namespace

std::string escaped(std::string_view text) {
    std::string markup;
    while (!text.empty()) {
        const std::size_t bytes = character_bytes(text);
        if (bytes == 0)
            markup += "\xEF\xBF\xBD"; // U+FFFD
        else if (const std::string_view name = entity(text[0]); !name.empty())
            markup += name;
        else
            markup += text.substr(0, bytes);
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return markup;
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
