#include "tools/explain/region_page.h"

#include "model/memory/pixel_format.h"
#include "tools/explain/history_text.h"
#include "tools/page/json_text.h"
#include "tools/page/page.h"

#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

constexpr std::string_view Body = R"(<header><h1>{}</h1>
<button id="theme" type="button">Dark</button>
<p>Click on a pixel, or move with the arrow keys.</p></header>
<main><canvas id="region" tabindex="0" role="img" aria-label="The region, magnified"></canvas>
<pre id="history" aria-live="polite"></pre></main>
)";

// Each line once, in the order in which they came.
class LineTable {
public:
    std::vector<std::size_t> numbers(std::string_view text) {
        std::vector<std::size_t> numbers;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            numbers.push_back(number(std::string(text.substr(begin, end - begin))));
            begin = end + 1;
        }
        return numbers;
    }

    const std::vector<std::string>& lines() const { return lines_; }

private:
    std::size_t number(const std::string& line) {
        const auto [found, is_new] = numbers_.emplace(line, lines_.size());
        if (is_new) lines_.push_back(line);
        return found->second;
    }

    std::map<std::string, std::size_t> numbers_;
    std::vector<std::string> lines_;
};

} // namespace

std::string region_page(const PageRegion& region, std::span<const PixelHistory> histories) {
    LineTable table;
    nlohmann::ordered_json data{{"width", region.width}, {"height", region.height}};
    for (const PixelHistory& history : histories) {
        const PixelColor color = unpack_rgba8(history.value);
        data["colors"].push_back(fmt::format("{:02x}{:02x}{:02x}", color[0], color[1], color[2]));
        data["pixels"].push_back(table.numbers(history_text(history)));
    }
    data["lines"] = table.lines();
    return html_of({.title = "ffgpu explain: " + region.title,
                    .body = fmt::format(Body, escaped(region.title)),
                    .data = json_text(data),
                    .css = {"region.css"},
                    .code = {"region.js"}});
}

} // namespace ffgpu::tools
