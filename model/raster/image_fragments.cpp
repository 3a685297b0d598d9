#include "model/raster/image_fragments.h"

#include "model/memory/pixel_format.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ffgpu {
namespace {

constexpr std::int32_t Outside = -1;

// Along one axis: which of `count` image columns (or rows) covers which fragment.
class ZoomedAxis {
public:
    ZoomedAxis(float origin, float zoom, std::uint32_t count)
        : origin_(origin)
        , zoom_(zoom)
        , count_(count) {}

    bool empty() const {
        return count_ == 0 || zoom_ == 0.0 || !std::isfinite(zoom_) || !std::isfinite(origin_);
    }

    // The image column over the centre of fragment `at`, or Outside.
    std::int32_t source(int at) const {
        const double u = (at + 0.5 - origin_) / zoom_;
        const double index = zoom_ > 0 ? std::floor(u) : std::ceil(u) - 1.0;
        return index >= 0.0 && index < count_ ? static_cast<std::int32_t>(index) : Outside;
    }

private:
    double origin_, zoom_;
    double count_;
};

struct Axes {
    ZoomedAxis x, y;

    explicit Axes(const DrawImageCommand& image)
        : x(image.x, image.zoom_x, image.width)
        , y(image.y, image.zoom_y, image.height) {}

    bool empty() const { return x.empty() || y.empty(); }
};

// First and last + 1 of begin .. end - 1 that the axis covers; source() is monotonic.
std::pair<int, int> covered(const ZoomedAxis& axis, int begin, int end) {
    while (begin < end && axis.source(begin) == Outside)
        ++begin;
    while (begin < end && axis.source(end - 1) == Outside)
        --end;
    return {begin, end};
}

// The image column of each fragment begin .. end - 1.
std::vector<std::int32_t> sources(const ZoomedAxis& axis, int begin, int end) {
    std::vector<std::int32_t> table;
    for (int at = begin; at < end; ++at)
        table.push_back(axis.source(at));
    return table;
}

bool is_image_format(Format format) {
    return format == Format::Rgba8 || format == Format::Depth24Stencil8 ||
           format == Format::Bitmap || format == Format::Stencil8;
}

bool image_fits(const DrawImageCommand& image, std::uint64_t memory_size) {
    if (!is_image_format(image.format) || image.width == 0 || image.height == 0) return false;
    const std::uint64_t row =
        image.format == Format::Bitmap
            ? (std::uint64_t{image.width} + 7) / 8
            : std::uint64_t{image.width} * format_info(image.format).block_bytes;
    // The products of 32-bit factors leave room for the sums.
    return std::uint64_t{image.height - 1} * image.stride <= memory_size &&
           image.address + std::uint64_t{image.height - 1} * image.stride + row <= memory_size;
}

// What all fragments of an image share.
struct Constants {
    PixelColor color, secondary;
    std::uint32_t depth;
    float fog_coordinate;

    Constants(const DrawImageCommand& image, Format depth_target)
        : depth(depth_units(depth_target, image.depth))
        , fog_coordinate(image.fog_coordinate) {
        for (unsigned channel = 0; channel < 4; ++channel) {
            color[channel] = unorm8_from_float(image.color[channel]);
            secondary[channel] = unorm8_from_float(image.secondary_color[channel]);
        }
        secondary[3] = 0;
    }
};

class ImageReader {
public:
    ImageReader(const DrawImageCommand& image,
                const DrawState& state,
                std::span<const std::byte> memory)
        : image_(image)
        , pixels_(memory.data() + image.address)
        , depth_target_(state.regs().targets.depth.format)
        , constants_(image, depth_target_) {}

    // Fills one lane from image pixel (i, j); false: no fragment there.
    bool read(FragmentBatch& batch, unsigned lane, std::uint32_t i, std::uint32_t j) const {
        const std::byte* row = pixels_ + std::uint64_t{j} * image_.stride;
        PixelColor color = constants_.color;
        std::uint32_t depth = constants_.depth;
        switch (image_.format) {
        case Format::Bitmap:
            if ((load_word<std::uint8_t>(row + i / 8) >> (i % 8) & 1) == 0) return false;
            break;
        case Format::Depth24Stencil8:
            depth = load_word<std::uint32_t>(row + std::size_t{4} * i) >> 8;
            if (depth_target_ == Format::Depth16) depth = depth16_from_depth24(depth);
            break;
        default:
            color = unpack_rgba8(load_word<std::uint32_t>(row + std::size_t{4} * i));
        }
        set_color(batch.primary, lane, color);
        batch.depth[lane] = depth;
        return true;
    }

    // What every lane gets, covered or not.
    void fill_constants(FragmentBatch& batch) const {
        for (unsigned lane = 0; lane < BatchFragments; ++lane) {
            set_color(batch.primary, lane, constants_.color);
            set_color(batch.secondary, lane, constants_.secondary);
        }
        batch.depth.fill(constants_.depth);
        batch.fog_coordinate.fill(constants_.fog_coordinate);
        batch.antialias.fill(255);
        batch.primitive.fill(0);
        batch.front_facing.fill(~std::uint64_t{0});
    }

private:
    static void set_color(ColorPlanes& planes, unsigned lane, const PixelColor& color) {
        planes.r[lane] = color[0];
        planes.g[lane] = color[1];
        planes.b[lane] = color[2];
        planes.a[lane] = color[3];
    }

    const DrawImageCommand& image_;
    const std::byte* pixels_;
    Format depth_target_;
    Constants constants_;
};

// Collects quads and hands full batches on.
class BatchBuilder {
public:
    BatchBuilder(const ImageReader& reader, Rectangle tile, const ImageBatchSink& sink)
        : reader_(reader)
        , sink_(sink)
        , tile_x_(static_cast<std::uint16_t>(tile.x0 & ~1))
        , tile_y_(static_cast<std::uint16_t>(tile.y0 & ~1)) {}

    // The next quad, at (x, y); columns and rows are the image's, Outside where there is none.
    void quad(int x, int y, const std::int32_t (&columns)[2], const std::int32_t (&rows)[2]) {
        if (batch_.quad_count == 0) begin();
        const unsigned first = batch_.lanes();
        bool any = false;
        for (unsigned lane = 0; lane < 4; ++lane) {
            const std::int32_t i = columns[lane & 1], j = rows[lane >> 1];
            if (i == Outside || j == Outside) continue;
            if (!reader_.read(batch_,
                              first + lane,
                              static_cast<std::uint32_t>(i),
                              static_cast<std::uint32_t>(j)))
                continue;
            batch_.live.set(first + lane);
            any = true;
        }
        if (!any) return;
        batch_.x[batch_.quad_count] = static_cast<std::uint16_t>(x);
        batch_.y[batch_.quad_count] = static_cast<std::uint16_t>(y);
        if (++batch_.quad_count == BatchQuads) flush();
    }

    void flush() {
        if (batch_.quad_count != 0) sink_(batch_);
        batch_.quad_count = 0;
    }

private:
    // The sink may have changed anything.
    void begin() {
        batch_.tile_x = tile_x_;
        batch_.tile_y = tile_y_;
        batch_.live = {};
        reader_.fill_constants(batch_);
    }

    const ImageReader& reader_;
    const ImageBatchSink& sink_;
    std::uint16_t tile_x_, tile_y_;
    FragmentBatch batch_;
};

} // namespace

Rectangle image_bounds(const DrawImageCommand& image, Rectangle window) {
    const Axes axes(image);
    if (window.empty() || axes.empty()) return {};
    const auto [x0, x1] = covered(axes.x, window.x0, window.x1);
    const auto [y0, y1] = covered(axes.y, window.y0, window.y1);
    const Rectangle bounds{x0, y0, x1, y1};
    return bounds.empty() ? Rectangle{} : bounds;
}

void image_fragments(const DrawImageCommand& image,
                     const DrawState& state,
                     Rectangle tile,
                     std::span<const std::byte> memory,
                     const ImageBatchSink& sink) {
    if (image.format == Format::Stencil8 || !image_fits(image, memory.size())) return;
    const Axes axes(image);
    const Rectangle bounds = image_bounds(image, tile);
    if (bounds.empty()) return;

    // Whole quads around the bounds; what lies outside of them is no fragment.
    const auto table = [](const ZoomedAxis& axis, int begin, int end) {
        std::vector<std::int32_t> columns((begin & 1) != 0 ? 1u : 0u, Outside);
        const std::vector<std::int32_t> inside = sources(axis, begin, end);
        columns.insert(columns.end(), inside.begin(), inside.end());
        if (columns.size() % 2 != 0) columns.push_back(Outside);
        return columns;
    };
    const std::vector<std::int32_t> columns = table(axes.x, bounds.x0, bounds.x1);
    const std::vector<std::int32_t> rows = table(axes.y, bounds.y0, bounds.y1);

    const ImageReader reader(image, state, memory);
    BatchBuilder builder(reader, tile, sink);
    for (std::size_t y = 0; y < rows.size(); y += 2)
        for (std::size_t x = 0; x < columns.size(); x += 2)
            builder.quad((bounds.x0 & ~1) + static_cast<int>(x),
                         (bounds.y0 & ~1) + static_cast<int>(y),
                         {columns[x], columns[x + 1]},
                         {rows[y], rows[y + 1]});
    builder.flush();
}

void draw_stencil_image(const DrawImageCommand& image,
                        const Registers& registers,
                        Rectangle tile,
                        std::span<std::byte> memory) {
    const Surface& target = registers.targets.depth;
    if (image.format != Format::Stencil8 || !image_fits(image, memory.size())) return;
    if (target.format != Format::Depth24Stencil8 || !surface_fits(target, memory.size())) return;
    const Axes axes(image);
    const Rectangle bounds =
        image_bounds(image, intersect(tile, {0, 0, target.width, target.height}));
    const std::uint32_t mask = registers.stencil.front.write_mask;
    const std::vector<std::int32_t> columns = sources(axes.x, bounds.x0, bounds.x1);
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        const std::byte* row =
            memory.data() + image.address + std::uint64_t(axes.y.source(y)) * image.stride;
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const auto column = static_cast<std::size_t>(columns[std::size_t(x - bounds.x0)]);
            const std::uint32_t value = load_word<std::uint8_t>(row + column);
            std::byte* at = pixel_address(
                target, memory, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            const std::uint32_t stored = load_word<std::uint32_t>(at);
            store_word(at, (stored & ~mask) | (value & mask));
        }
    }
}

} // namespace ffgpu
