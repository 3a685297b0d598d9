#include "tools/explain/region_page.h"

#include "model/memory/pixel_format.h"
#include "tools/explain/history_text.h"

#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

constexpr std::string_view Before = R"(<!doctype html>
<html lang="en"><meta charset="utf-8"><title>ffgpu explain</title>
<style>
body { font: 14px sans-serif; margin: 1em; background: #fff; color: #111 }
main { display: flex; gap: 1em; align-items: flex-start }
canvas { image-rendering: pixelated; cursor: crosshair; border: 1px solid #888; flex: none }
pre { margin: 0; font: 12px monospace; white-space: pre-wrap; max-height: 92vh; overflow: auto }
</style>
<h1></h1><p>Click on a pixel, or move with the arrow keys.</p>
<main><canvas id="region" tabindex="0"></canvas><pre id="history"></pre></main>
<script type="application/json" id="data">)";

// Texts are lists of numbers of lines: most lines are those of many pixels.
constexpr std::string_view After = R"(</script>
<script>
const data = JSON.parse(document.getElementById('data').textContent);
const canvas = document.getElementById('region'), pen = canvas.getContext('2d');
const zoom = Math.max(4, Math.min(32, Math.floor(640 / Math.max(data.width, data.height))));
let at = { x: 0, y: 0 };
document.querySelector('h1').textContent = data.title;
canvas.width = data.width * zoom;
canvas.height = data.height * zoom;
function show() {
  data.colors.forEach((color, i) => {
    pen.fillStyle = '#' + color;
    pen.fillRect(i % data.width * zoom, Math.floor(i / data.width) * zoom, zoom, zoom);
  });
  pen.strokeStyle = '#f0c';
  pen.lineWidth = 2;
  pen.strokeRect(at.x * zoom + 1, at.y * zoom + 1, zoom - 2, zoom - 2);
  const lines = data.pixels[at.y * data.width + at.x];
  document.getElementById('history').textContent = lines.map(i => data.lines[i]).join('\n');
}
function move(x, y) {
  const within = (value, size) => Math.max(0, Math.min(size - 1, value));
  at = { x: within(x, data.width), y: within(y, data.height) };
  show();
}
canvas.onclick = event =>
  move(Math.floor(event.offsetX / zoom), Math.floor(event.offsetY / zoom));
document.onkeydown = event => {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const step = steps[event.key];
  if (!step) return;
  event.preventDefault();
  move(at.x + step[0], at.y + step[1]);
};
show();
</script>
</html>
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

// JSON within HTML: nothing in it may end the script.
std::string without_tags(std::string json) {
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
        json.replace(at, 1, "\\u003c");
    return json;
}

} // namespace

std::string region_page(const PageRegion& region, std::span<const PixelHistory> histories) {
    LineTable table;
    nlohmann::ordered_json data{
        {"title", region.title}, {"width", region.width}, {"height", region.height}};
    for (const PixelHistory& history : histories) {
        const PixelColor color = unpack_rgba8(history.value);
        data["colors"].push_back(fmt::format("{:02x}{:02x}{:02x}", color[0], color[1], color[2]));
        data["pixels"].push_back(table.numbers(history_text(history)));
    }
    data["lines"] = table.lines();
    return std::string(Before) + without_tags(data.dump()) + std::string(After);
}

} // namespace ffgpu::tools
