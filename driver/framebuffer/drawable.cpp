#include "driver/framebuffer/drawable.h"

#include "model/base/check.h"
#include "model/device/layout/limits.h"

#include <algorithm>
#include <new>
#include <utility>

namespace ffgpu::gl {
namespace {

constexpr std::uint32_t RowAlignment = 64; // bytes: each row begins a line of any cache

Format color_format(const PixelFormat& format) {
    return format.alpha ? Format::Rgba8 : Format::Rgbx8;
}

Format depth_format(const PixelFormat& format) {
    if (format.stencil_bits > 0 || format.depth_bits > 16) return Format::Depth24Stencil8;
    return format.depth_bits > 0 ? Format::Depth16 : Format::None;
}

unsigned cut(unsigned size) {
    return std::min(size, MaxSurfaceSize);
}

} // namespace

Drawable::Drawable(
    Device& device, MemoryAllocator& memory, PixelFormat format, unsigned width, unsigned height)
    : device_(device)
    , memory_(memory)
    , format_(format)
    , width_(cut(width))
    , height_(cut(height))
    , surfaces_(allocate_all(width_, height_)) {}

Drawable::~Drawable() {
    release(surfaces_);
}

void Drawable::resize(unsigned width, unsigned height) {
    width = cut(width);
    height = cut(height);
    if (width == width_ && height == height_) return;
    settle();

    const Surfaces larger = allocate_all(width, height);
    copy_pictures(surfaces_.front, larger.front);
    copy_pictures(surfaces_.back, larger.back);
    copy_pictures(surfaces_.depth, larger.depth);
    release(surfaces_);
    surfaces_ = larger;
    resolved_from_.reset();
    width_ = width;
    height_ = height;
    accumulation_.clear();
    ++generation_;
}

void Drawable::swap(SwapMode mode) {
    if (!format_.double_buffer || copy_is_due_) return; // The buffers hold the same.
    std::swap(surfaces_.front, surfaces_.back);
    copy_is_due_ = mode == SwapMode::Copy;
    ++generation_;
}

void Drawable::copy_to_back() {
    copy_is_due_ = false;
    copy_pictures(surfaces_.front, surfaces_.back);
    if (resolved_from_ == surfaces_.back.address) resolved_from_.reset();
}

std::vector<std::int16_t>& Drawable::accumulation() {
    if (format_.accumulation) accumulation_.resize(std::size_t{4} * width_ * height_);
    return accumulation_;
}

Surface Drawable::allocate(const Surface& shape, unsigned pictures) {
    Surface surface = shape;
    surface.stride =
        (row_bytes(shape.format, shape.width) + RowAlignment - 1) & ~(RowAlignment - 1);
    const auto address = memory_.allocate(surface.bytes() * pictures);
    if (!address) throw std::bad_alloc();
    surface.address = *address;
    return surface;
}

Drawable::Surfaces Drawable::allocate_all(unsigned width, unsigned height) {
    Surfaces made;
    const unsigned pictures = format_.supersampling;
    const Surface pixels{.format = color_format(format_),
                         .width = static_cast<std::uint16_t>(width),
                         .height = static_cast<std::uint16_t>(height)};
    Surface color = pixels, depth = pixels;
    color.samples = depth.samples = format_.samples;
    depth.format = depth_format(format_);
    try {
        made.front = allocate(color, pictures);
        if (format_.double_buffer) made.back = allocate(color, pictures);
        if (depth.format != Format::None) made.depth = allocate(depth, pictures);
        if (is_resolved()) made.resolved = allocate(pixels, 1);
    } catch (const std::bad_alloc&) {
        release(made);
        throw;
    }
    clear(made.front);
    clear(made.back);
    clear(made.depth);
    return made;
}

void Drawable::release(Surfaces& surfaces) {
    for (Surface* surface :
         {&surfaces.front, &surfaces.back, &surfaces.depth, &surfaces.resolved}) {
        if (surface->format != Format::None) memory_.release(surface->address);
        *surface = {};
    }
}

void Drawable::clear(const Surface& surface) {
    const std::vector<std::byte> zeroes(surface.bytes() * format_.supersampling);
    if (!zeroes.empty()) device_.write_memory(surface.address, zeroes);
}

void Drawable::copy_pictures(const Surface& from, const Surface& to) {
    if (format_.supersampling == 1) return copy_common_part({.source = from, .destination = to});
    for (unsigned i = 0; i < format_.supersampling; ++i)
        copy_common_part({.source = from.plane(i), .destination = to.plane(i)});
}

void Drawable::copy_common_part(const CopyRectangleCommand& surfaces) {
    CopyRectangleCommand copy = surfaces;
    copy.width = std::min(copy.source.width, copy.destination.width);
    copy.height = std::min(copy.source.height, copy.destination.height);
    if (copy.width == 0 || copy.height == 0) return;
    CommandStream commands;
    commands.add(copy);
    device_.submit(commands);
}

Surface Drawable::resolve(const Surface& buffer) {
    if (!is_resolved()) return buffer;
    if (resolved_from_ != buffer.address)
        copy_common_part({.source = buffer,
                          .destination = surfaces_.resolved,
                          .pictures = format_.supersampling});
    resolved_from_ = buffer.address;
    return surfaces_.resolved;
}

} // namespace ffgpu::gl
