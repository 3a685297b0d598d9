#include "model/raster/image_fragments.h"

#include "model/device/extents.h"
#include "model/raster/image_axes.h"
#include "model/raster/image_reader.h"
#include "model/raster/sample_positions.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ffgpu {
namespace {

constexpr std::int32_t Outside = ZoomedAxis::Outside;

struct Range {
    int begin, end;
};

// Of begin .. end - 1 the part that the axis covers `beside` (1/256 pixel) the centres; source()
// is monotonic.
Range covered(const ZoomedAxis& axis, Range range, std::int32_t beside) {
    while (range.begin < range.end && axis.source(range.begin, beside) == Outside)
        ++range.begin;
    while (range.begin < range.end && axis.source(range.end - 1, beside) == Outside)
        --range.end;
    return range;
}

// The image column of each fragment begin .. end - 1.
std::vector<std::int32_t> sources(const ZoomedAxis& axis, Range range, std::int32_t beside) {
    std::vector<std::int32_t> table;
    for (int at = range.begin; at < range.end; ++at)
        table.push_back(axis.source(at, beside));
    return table;
}

// The same of whole quads around the range; what lies outside of it is no fragment.
std::vector<std::int32_t> quad_sources(const ZoomedAxis& axis, Range range, std::int32_t beside) {
    std::vector<std::int32_t> table((range.begin & 1) != 0 ? 1u : 0u, Outside);
    const std::vector<std::int32_t> inside = sources(axis, range, beside);
    table.insert(table.end(), inside.begin(), inside.end());
    if (table.size() % 2 != 0) table.push_back(Outside);
    return table;
}

Rectangle bounds_beside(const ImageAxes& axes, const Rectangle& window, SubPixelPoint beside) {
    const Range x = covered(axes.x, {window.x0, window.x1}, beside.x);
    const Range y = covered(axes.y, {window.y0, window.y1}, beside.y);
    return {x.begin, y.begin, x.end, y.end};
}

Rectangle around(const Rectangle& a, const Rectangle& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// The image pixel over a fragment's centre or samples; column Outside: none.
struct ImagePixel {
    std::int32_t column = Outside, row = Outside;

    bool is_outside() const { return column == Outside || row == Outside; }
    bool operator==(const ImagePixel&) const = default;
};

// A quad's four lanes, and the samples, a bit each, that they cover.
struct ImageQuad {
    std::array<ImagePixel, 4> pixels;
    std::array<std::uint8_t, 4> samples{};
};

// Collects quads and hands full batches on.
class BatchBuilder {
public:
    BatchBuilder(const ImageReader& reader, Rectangle tile, const ImageBatchSink& sink)
        : reader_(reader)
        , sink_(sink)
        , tile_x_(static_cast<std::uint16_t>(tile.x0 & ~1))
        , tile_y_(static_cast<std::uint16_t>(tile.y0 & ~1)) {}

    void quad(int x, int y, const ImageQuad& quad) {
        if (batch_.quad_count == 0) begin();
        const unsigned first = batch_.lanes();
        bool any = false;
        for (unsigned i = 0; i < 4; ++i) {
            const ImagePixel pixel = quad.pixels[i];
            if (pixel.is_outside()) continue;
            if (!reader_.read(batch_,
                              first + i,
                              static_cast<std::uint32_t>(pixel.column),
                              static_cast<std::uint32_t>(pixel.row)))
                continue;
            batch_.live.set(first + i);
            for (unsigned sample = 0; sample < MaxSamples; ++sample)
                if ((quad.samples[i] >> sample & 1) != 0) batch_.samples[sample].set(first + i);
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
        batch_.samples = {};
        reader_.fill_constants(batch_);
    }

    const ImageReader& reader_;
    const ImageBatchSink& sink_;
    std::uint16_t tile_x_, tile_y_;
    FragmentBatch batch_;
};

// The image pixels over each point of the bounds' quads, at one place in each pixel.
class SourceTable {
public:
    SourceTable(const ImageAxes& axes, const Rectangle& bounds, SubPixelPoint beside)
        : columns_(quad_sources(axes.x, {bounds.x0, bounds.x1}, beside.x))
        , rows_(quad_sources(axes.y, {bounds.y0, bounds.y1}, beside.y)) {}

    std::size_t width() const { return columns_.size(); }
    std::size_t height() const { return rows_.size(); }

    // Of lane `lane` of the quad at (x, y), counted from the lower left quad's corner.
    ImagePixel pixel(std::size_t x, std::size_t y, unsigned lane) const {
        return {columns_[x + (lane & 1)], rows_[y + (lane >> 1)]};
    }

private:
    std::vector<std::int32_t> columns_, rows_;
};

// Each pixel makes a fragment of the image pixel over its centre.
void add_centres(const ImageAxes& axes, const Rectangle& bounds, BatchBuilder& builder) {
    const SourceTable table(axes, bounds, {});
    for (std::size_t y = 0; y < table.height(); y += 2)
        for (std::size_t x = 0; x < table.width(); x += 2) {
            ImageQuad quad;
            for (unsigned lane = 0; lane < 4; ++lane)
                quad.pixels[lane] = table.pixel(x, y, lane);
            builder.quad((bounds.x0 & ~1) + static_cast<int>(x),
                         (bounds.y0 & ~1) + static_cast<int>(y),
                         quad);
        }
}

// A pixel's samples may lie in several image pixels: each makes a fragment of its own, so the quad
// comes up to four times, with other samples.
void add_samples(const ImageAxes& axes, const Rectangle& bounds, BatchBuilder& builder) {
    const auto table_of = [&](unsigned i) { return SourceTable(axes, bounds, SamplePositions[i]); };
    const std::array<SourceTable, MaxSamples> tables{
        table_of(0), table_of(1), table_of(2), table_of(3)};
    for (std::size_t y = 0; y < tables[0].height(); y += 2)
        for (std::size_t x = 0; x < tables[0].width(); x += 2) {
            std::array<unsigned, 4> left{0xf, 0xf, 0xf, 0xf}; // samples without a fragment, by lane
            while ((left[0] | left[1] | left[2] | left[3]) != 0) {
                ImageQuad quad;
                for (unsigned lane = 0; lane < 4; ++lane)
                    for (unsigned i = 0; i < MaxSamples; ++i) {
                        if ((left[lane] >> i & 1) == 0) continue;
                        const ImagePixel pixel = tables[i].pixel(x, y, lane);
                        if (quad.samples[lane] == 0) quad.pixels[lane] = pixel;
                        if (pixel != quad.pixels[lane]) continue;
                        quad.samples[lane] |= static_cast<std::uint8_t>(1u << i);
                        left[lane] &= ~(1u << i);
                    }
                builder.quad((bounds.x0 & ~1) + static_cast<int>(x),
                             (bounds.y0 & ~1) + static_cast<int>(y),
                             quad);
            }
        }
}

// Writes one plane's pixels, those that the image covers `beside` their centres.
void draw_stencil_plane(const DrawImageCommand& image,
                        const Surface& plane,
                        std::uint32_t mask,
                        Rectangle window,
                        SubPixelPoint beside,
                        std::span<std::byte> memory) {
    const ImageAxes axes(image);
    if (axes.empty()) return;
    const Rectangle bounds = bounds_beside(axes, window, beside);
    const std::vector<std::int32_t> columns = sources(axes.x, {bounds.x0, bounds.x1}, beside.x);
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        const auto row_number = static_cast<std::uint64_t>(axes.y.source(y, beside.y));
        const std::byte* row = memory.data() + image.address + row_number * image.stride;
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const auto column = static_cast<std::size_t>(columns[std::size_t(x - bounds.x0)]);
            const std::uint32_t value = load_word<std::uint8_t>(row + column);
            std::byte* at = pixel_address(
                plane, memory, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
            const std::uint32_t stored = load_word<std::uint32_t>(at);
            store_word(at, (stored & ~mask) | (value & mask));
        }
    }
}

} // namespace

Rectangle image_bounds(const DrawImageCommand& image, Rectangle window, bool multisample) {
    const ImageAxes axes(image);
    if (window.empty() || axes.empty()) return {};
    Rectangle bounds = multisample ? Rectangle{} : bounds_beside(axes, window, {});
    for (unsigned i = 0; multisample && i < MaxSamples; ++i)
        bounds = around(bounds, bounds_beside(axes, window, SamplePositions[i]));
    return bounds.empty() ? Rectangle{} : bounds;
}

void image_fragments(const DrawImageCommand& image,
                     const DrawState& state,
                     Rectangle tile,
                     std::span<const std::byte> memory,
                     const ImageBatchSink& sink) {
    if (image.format == Format::Stencil8 || !image_fits(image, memory.size())) return;
    const Rectangle bounds = image_bounds(image, tile, state.multisample);
    if (bounds.empty()) return;
    const ImageReader reader(image, state, memory);
    BatchBuilder builder(reader, tile, sink);
    const ImageAxes axes(image);
    if (state.multisample)
        add_samples(axes, bounds, builder);
    else
        add_centres(axes, bounds, builder);
    builder.flush();
}

void draw_stencil_image(const DrawImageCommand& image,
                        const Registers& registers,
                        Rectangle tile,
                        std::span<std::byte> memory) {
    const Surface& target = registers.targets.depth;
    if (image.format != Format::Stencil8 || !image_fits(image, memory.size())) return;
    if (target.format != Format::Depth24Stencil8 || !surface_fits(target, memory.size())) return;
    const Rectangle window = intersect(tile, {0, 0, target.width, target.height});
    if (window.empty()) return;
    for (unsigned i = 0; i < target.samples; ++i) {
        const bool at_sample = target.samples > 1 && registers.multisample.enable;
        draw_stencil_plane(image,
                           target.plane(i),
                           registers.stencil.front.write_mask,
                           window,
                           at_sample ? SamplePositions[i] : SubPixelPoint{},
                           memory);
    }
}

} // namespace ffgpu
