#include "tools/explain/footprint_picture.h"

#include "model/texture/texel_read.h"
#include "tools/explain/footprint.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace ffgpu::tools {
namespace {

constexpr unsigned Cell = 24, Gap = 6, Around = 2; // pixels, pixels, texels

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb Background{40, 40, 40}, Frame{255, 255, 255}, Bar{255, 60, 200};

struct Box {
    unsigned x = 0, y = 0, width = 0, height = 0;
};

void fill(Image& image, const Box& box, const Rgb& color) {
    for (unsigned y = box.y; y < box.y + box.height; ++y)
        for (unsigned x = box.x; x < box.x + box.width; ++x)
            std::ranges::copy(color, image.rgb.begin() + 3 * (std::ptrdiff_t{y} * image.width + x));
}

void put(const Image& from, Image& to, unsigned x, unsigned y) {
    for (unsigned row = 0; row < from.height; ++row)
        std::copy_n(from.rgb.begin() + 3 * std::ptrdiff_t{row} * from.width,
                    3 * from.width,
                    to.rgb.begin() + 3 * (std::ptrdiff_t{y + row} * to.width + x));
}

// A texture's image as it lay in memory when it was read.
class ReadTexture {
public:
    ReadTexture(FunctionalGpu& gpu, TextureImage image, const Sampler& sampler)
        : bytes_(texture_bytes(image.shape) + DeviceMemory::SlackBytes) {
        const std::size_t size = texture_bytes(image.shape);
        gpu.read_memory(image.address, std::span(bytes_).first(size));
        image.address = 0;
        Sampler plain = sampler;
        plain.compare_enable = false;
        unit_ = compile_texture_unit(image, plain, std::span(bytes_).first(size));
    }

    // Stored texels of a level along an axis: 0 x, 1 y.
    unsigned size(unsigned axis, unsigned level) const {
        return static_cast<unsigned>(level_extent(unit_, axis, level) +
                                     (axis < unit_.dimensions ? 2 * unit_.border : 0));
    }

    Rgb color(const TexelName& texel) const {
        const auto place = [&](unsigned at) { return static_cast<int>(at) - unit_.border; };
        const bool cube = unit_.kind == TextureKind::Cube;
        const Rgba color = read_texel(unit_,
                                      {.level = texel.level,
                                       .face = cube ? texel.layer : 0,
                                       .x = place(texel.x),
                                       .y = unit_.dimensions > 1 ? place(texel.y) : 0,
                                       .z = unit_.dimensions > 2 ? place(texel.layer) : 0},
                                      0,
                                      nullptr);
        return {color[0], color[1], color[2]};
    }

private:
    std::vector<std::byte> bytes_;
    TextureUnit unit_;
};

// Where columns or rows of texels stand in a panel, in rising order.
class Axis {
public:
    Axis(const std::set<unsigned>& read, unsigned size) {
        for (const unsigned at : read)
            for (unsigned i = at < Around ? 0 : at - Around; i <= at + Around && i < size; ++i)
                texels_.insert(i);
        unsigned before = *texels_.begin();
        for (const unsigned at : texels_) {
            if (at > before + 1) length_ += Gap;
            begins_.push_back(length_);
            length_ += Cell;
            before = at;
        }
    }

    const std::set<unsigned>& texels() const { return texels_; }
    unsigned length() const { return length_; }
    unsigned begin(unsigned texel) const {
        return begins_[static_cast<std::size_t>(
            std::distance(texels_.begin(), texels_.find(texel)))];
    }

private:
    std::set<unsigned> texels_;
    std::vector<unsigned> begins_;
    unsigned length_ = 0;
};

void draw_texel(Image& panel, const Box& box, const Rgb& color, double share) {
    fill(panel, box, share > 0 ? Frame : color);
    if (share <= 0) return;
    fill(panel, {box.x + 2, box.y + 2, box.width - 4, box.height - 4}, color);
    const auto width = static_cast<unsigned>(std::lround((Cell - 4) * share));
    fill(panel, {box.x + 2, box.y + box.height - 6, width, 4}, Bar);
}

using Shares = std::map<TexelName, double>;

// `shares`: of one level and layer.
Image draw_panel(const ReadTexture& texture, const Shares& shares) {
    std::set<unsigned> columns, rows;
    for (const auto& [texel, share] : shares) {
        columns.insert(texel.x);
        rows.insert(texel.y);
    }
    TexelName at = shares.begin()->first;
    const Axis x(columns, texture.size(0, at.level)), y(rows, texture.size(1, at.level));
    Image panel(x.length(), y.length());
    fill(panel, {0, 0, panel.width, panel.height}, Background);
    for (const unsigned row : y.texels())
        for (const unsigned column : x.texels()) {
            at.x = column;
            at.y = row;
            const auto found = shares.find(at);
            draw_texel(panel,
                       {x.begin(column), y.length() - y.begin(row) - Cell, Cell, Cell},
                       texture.color(at),
                       found == shares.end() ? 0 : found->second);
        }
    return panel;
}

using Row = std::vector<Image>;

Row draw_row(FunctionalGpu& gpu, const FragmentNote& fragment, const TextureNote& note) {
    std::map<std::pair<unsigned, unsigned>, Shares> panels;
    for (const auto& [texel, share] : texel_shares(note))
        panels[{texel.level, texel.layer}][texel] = share;
    if (panels.empty()) return {};
    const Registers& registers = fragment.registers();
    const ReadTexture texture(gpu, registers.images[note.unit], registers.samplers[note.unit]);
    Row row;
    for (const auto& [name, shares] : panels)
        row.push_back(draw_panel(texture, shares));
    return row;
}

Image assemble(const std::vector<Row>& rows) {
    unsigned width = 0, height = Gap;
    for (const Row& row : rows) {
        unsigned sum = Gap, tallest = 0;
        for (const Image& panel : row) {
            sum += panel.width + Gap;
            tallest = std::max(tallest, panel.height);
        }
        width = std::max(width, sum);
        height += tallest + Gap;
    }
    if (rows.empty()) return {};
    Image image(width, height);
    unsigned y = Gap;
    for (const Row& row : rows) {
        unsigned x = Gap, tallest = 0;
        for (const Image& panel : row) {
            put(panel, image, x, y);
            x += panel.width + Gap;
            tallest = std::max(tallest, panel.height);
        }
        y += tallest + Gap;
    }
    return image;
}

} // namespace

Image footprint_picture(const FrameTape& tape, const PixelHistory& history) {
    FunctionalGpu gpu({});
    tape.prepare(gpu);
    std::size_t played = 0;
    std::vector<Row> rows;
    for (const PixelEvent& event : history.events) {
        if (!event.fragment) continue;
        for (; played < event.step; ++played)
            FrameTape::play(tape.steps[played], gpu);
        for (const TextureNote& note : event.fragment->textures)
            if (Row row = draw_row(gpu, *event.fragment, note); !row.empty())
                rows.push_back(std::move(row));
    }
    return assemble(rows);
}

} // namespace ffgpu::tools
