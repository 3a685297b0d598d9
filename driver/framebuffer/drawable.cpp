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
    copy_common_part(surfaces_.front, larger.front);
    copy_common_part(surfaces_.back, larger.back);
    copy_common_part(surfaces_.depth, larger.depth);
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
    copy_common_part(surfaces_.front, surfaces_.back);
    if (resolved_from_ == surfaces_.back.address) resolved_from_.reset();
}

std::vector<std::int16_t>& Drawable::accumulation() {
    if (format_.accumulation) accumulation_.resize(std::size_t{4} * width_ * height_);
    return accumulation_;
}

Surface Drawable::allocate(Format format, unsigned samples, unsigned width, unsigned height) {
    Surface surface{.address = 0,
                    .format = format,
                    .width = static_cast<std::uint16_t>(width),
                    .height = static_cast<std::uint16_t>(height),
                    .stride = (row_bytes(format, width) + RowAlignment - 1) & ~(RowAlignment - 1),
                    .samples = static_cast<std::uint8_t>(samples)};
    const auto address = memory_.allocate(surface.bytes());
    if (!address) throw std::bad_alloc();
    surface.address = *address;
    return surface;
}

Drawable::Surfaces Drawable::allocate_all(unsigned width, unsigned height) {
    Surfaces made;
    const Format color = color_format(format_), depth = depth_format(format_);
    const unsigned samples = format_.samples;
    try {
        made.front = allocate(color, samples, width, height);
        if (format_.double_buffer) made.back = allocate(color, samples, width, height);
        if (depth != Format::None) made.depth = allocate(depth, samples, width, height);
        if (samples > 1) made.resolved = allocate(color, 1, width, height);
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
    const std::vector<std::byte> zeroes(surface.bytes());
    if (!zeroes.empty()) device_.write_memory(surface.address, zeroes);
}

void Drawable::copy_common_part(const Surface& from, const Surface& to) {
    CopyRectangleCommand copy{.source = from, .destination = to};
    copy.width = std::min(from.width, to.width);
    copy.height = std::min(from.height, to.height);
    if (copy.width == 0 || copy.height == 0) return;
    CommandStream commands;
    commands.add(copy);
    device_.submit(commands);
}

Surface Drawable::resolve(const Surface& buffer) {
    if (buffer.samples == 1) return buffer;
    if (resolved_from_ != buffer.address) copy_common_part(buffer, surfaces_.resolved);
    resolved_from_ = buffer.address;
    return surfaces_.resolved;
}

} // namespace ffgpu::gl
