#include "model/raster/image_reader.h"

#include "model/arith/range.h"

namespace ffgpu {
namespace {

PixelColor color_from_floats(const std::array<float, 4>& channels) {
    PixelColor color{};
    for (unsigned channel = 0; channel < 4; ++channel)
        color[channel] = unorm8_from_float(channels[channel]);
    return color;
}

void set_color(ColorPlanes& planes, unsigned lane, const PixelColor& color) {
    planes.r[lane] = color[0];
    planes.g[lane] = color[1];
    planes.b[lane] = color[2];
    planes.a[lane] = color[3];
}

} // namespace

ImageReader::ImageReader(const DrawImageCommand& image,
                         const DrawState& state,
                         std::span<const std::byte> memory)
    : image_(image)
    , pixels_(memory.data() + image.address)
    , depth_target_(state.regs().targets.depth.format)
    , color_(color_from_floats(image.color))
    , secondary_(color_from_floats(image.secondary_color))
    , depth_(depth_units(depth_target_, image.depth)) {
    secondary_[3] = 0;
}

bool ImageReader::read(FragmentBatch& batch,
                       unsigned lane,
                       std::uint32_t i,
                       std::uint32_t j) const {
    const std::byte* row = pixels_ + std::uint64_t{j} * image_.stride;
    PixelColor color = color_;
    std::uint32_t depth = depth_;
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

void ImageReader::fill_constants(FragmentBatch& batch) const {
    for (unsigned lane = 0; lane < BatchFragments; ++lane) {
        set_color(batch.primary, lane, color_);
        set_color(batch.secondary, lane, secondary_);
    }
    batch.depth.fill(depth_);
    batch.fog_coordinate.fill(in_fog_range(image_.fog_coordinate));
    batch.antialias.fill(255);
    batch.primitive.fill(0);
    batch.front_facing.fill(~std::uint64_t{0});
}

} // namespace ffgpu
