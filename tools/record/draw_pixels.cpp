#include "tools/record/draw_pixels.h"

#include "model/timing/command_ledger.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

bool is_covered(const WorkQuad& quad, unsigned lane) {
    return (quad.covered >> lane & 1) != 0;
}

// Half open, in window coordinates.
struct Box {
    std::uint32_t x0 = ~0u, y0 = ~0u, x1 = 0, y1 = 0;

    bool empty() const { return x1 <= x0; }
    std::uint32_t width() const { return x1 - x0; }
    std::uint32_t height() const { return y1 - y0; }
    void add(std::uint32_t x, std::uint32_t y) {
        x0 = std::min(x0, x);
        y0 = std::min(y0, y);
        x1 = std::max(x1, x + 1);
        y1 = std::max(y1, y + 1);
    }
};

template <class Visitor>
void for_each_covered(const std::vector<WorkQuad>& quads, Visitor&& visit) {
    for (const WorkQuad& quad : quads)
        for (unsigned lane = 0; lane < 4; ++lane)
            if (is_covered(quad, lane))
                visit(quad.x + (lane & 1), quad.y + (lane >> 1), quad.after_depth >> lane & 1);
}

// The top row first.
std::vector<DrawnPixel> pixels_in(const Box& box, const std::vector<WorkQuad>& quads) {
    std::vector<DrawnPixel> pixels(std::size_t{box.width()} * box.height(), DrawnPixel::None);
    for_each_covered(quads, [&](std::uint32_t x, std::uint32_t y, bool is_written) {
        DrawnPixel& pixel = pixels[std::size_t{box.y1 - 1 - y} * box.width() + (x - box.x0)];
        if (is_written)
            pixel = DrawnPixel::Written;
        else if (pixel == DrawnPixel::None)
            pixel = DrawnPixel::Killed;
    });
    return pixels;
}

} // namespace

std::string pixel_runs(const std::vector<DrawnPixel>& pixels) {
    std::string text;
    for (auto begin = pixels.begin(); begin != pixels.end();) {
        const auto end =
            std::find_if(begin, pixels.end(), [&](DrawnPixel p) { return p != *begin; });
        text += static_cast<char>(*begin);
        text += std::to_string(end - begin);
        begin = end;
    }
    return text;
}

DrawPixels::DrawPixels(const std::string& path)
    : file_(path) {
    file_.write("frame,kind,draw,fragments_covered,fragments_written,left,top,width,height,"
                "pixels\n");
}

void DrawPixels::command(std::shared_ptr<const work::WholeCommand> command) {
    const WorkDraw& draw = command->draw;
    if (draw.kind != WorkKind::Draw && draw.kind != WorkKind::Image) return;
    Box box;
    for_each_covered(command->quads,
                     [&](std::uint32_t x, std::uint32_t y, bool) { box.add(x, y); });
    if (box.empty()) return;
    std::uint64_t covered = 0, written = 0;
    for (const WorkQuad& quad : command->quads) {
        covered += static_cast<unsigned>(std::popcount(quad.covered));
        written += static_cast<unsigned>(std::popcount(quad.after_depth));
    }
    const Surface& surface = draw.state->targets.color[0];
    const auto kind = static_cast<std::size_t>(timing::command_kind(draw.kind));
    rows_.push_back({surface,
                     fmt::format("{},{},{},{},{},{},{},{},{}",
                                 timing::CommandKindNames[kind],
                                 draw.number,
                                 covered,
                                 written,
                                 box.x0,
                                 surface.height - box.y1,
                                 box.width(),
                                 box.height(),
                                 pixel_runs(pixels_in(box, command->quads)))});
}

void DrawPixels::frame(std::uint64_t number, const Surface& shown) {
    std::string text;
    for (const Row& row : std::exchange(rows_, {}))
        if (row.surface.address == shown.address && row.surface.width == shown.width &&
            row.surface.height == shown.height)
            text += fmt::format("{},{}\n", number, row.text);
    file_.write(text);
}

} // namespace ffgpu::tools
