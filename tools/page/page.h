// Pages: one HTML file each, that holds all it shows and asks no network. What they have in common:
// the style sheet, a light and a dark look, and data as JSON for their scripts.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

struct Page {
    std::string title;                  // plain text
    std::string body;                   // HTML
    std::string data;                   // JSON; scripts read it from the element "data"
    std::vector<std::string_view> css;  // assets, behind page.css
    std::vector<std::string_view> code; // assets, in their order, behind theme.js
};

std::string html_of(const Page& page);

// Plain text as HTML or XML, also within double quotes. What is no UTF-8, or no character that XML
// allows, becomes U+FFFD: a file's name may be any bytes.
std::string escaped(std::string_view text);

} // namespace ffgpu::tools
