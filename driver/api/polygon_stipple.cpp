// The polygon stipple (GL 1.5, 3.5.2): a bitmap of 32 by 32 in the application's memory, under the
// pixel store's parameters.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/objects/buffer_object.h"

#include <cstdint>

namespace ffgpu::gl::api {
namespace {

constexpr std::size_t Size = 32;

// Where bit (x, y) of the bitmap stands (GL 1.5, 3.6.4, "bitmap").
class BitmapLayout {
public:
    explicit BitmapLayout(const PixelStore& store)
        : store_(store) {
        const std::size_t length = store.row_length > 0 ? to_size(store.row_length) : Size;
        const std::size_t alignment = to_size(store.alignment);
        stride_ = ((length + 7) / 8 + alignment - 1) / alignment * alignment;
    }

    std::size_t byte(std::size_t x, std::size_t y) const {
        const std::size_t row = to_size(store_.skip_rows) + (store_.invert ? Size - 1 - y : y);
        return row * stride_ + (to_size(store_.skip_pixels) + x) / 8;
    }

    std::uint8_t mask(std::size_t x) const {
        const std::size_t bit = (to_size(store_.skip_pixels) + x) % 8;
        return static_cast<std::uint8_t>(1u << (store_.lsb_first ? bit : 7 - bit));
    }

    std::size_t bytes() const { return byte(Size - 1, store_.invert ? 0 : Size - 1) + 1; }

private:
    static std::size_t to_size(GLint value) { return static_cast<std::size_t>(value); }

    const PixelStore& store_;
    std::size_t stride_;
};

// With a pixel buffer bound, `pointer` is an offset into it; null then where the bitmap does not
// lie within, or the buffer is mapped.
template <class Byte>
Byte* locate(const std::shared_ptr<BufferObject>& buffer, Byte* pointer, std::size_t bytes) {
    if (!buffer) return pointer;
    if (buffer->mapped) return nullptr;
    return reinterpret_cast<Byte*>(buffer->at(reinterpret_cast<std::uintptr_t>(pointer), bytes));
}

} // namespace

void PolygonStipple(Context& context, const GLubyte* mask) {
    const BitmapLayout layout(context.client.pixel_store.unpack);
    const auto& buffer = context.client.buffers.pixel_unpack;
    const GLubyte* const bytes = locate(buffer, mask, layout.bytes());
    if (!bytes) return buffer ? context.error(GL_INVALID_OPERATION) : void();

    PolygonStipplePattern& pattern = context.state.rasterization.polygon_stipple;
    for (std::size_t y = 0; y < Size; ++y) {
        pattern[y] = 0;
        for (std::size_t x = 0; x < Size; ++x) {
            if (bytes[layout.byte(x, y)] & layout.mask(x)) pattern[y] |= 0x80000000u >> x;
        }
    }
    context.dirty.mark(Dirty::Primitive);
}

void GetPolygonStipple(Context& context, GLubyte* mask) {
    const BitmapLayout layout(context.client.pixel_store.pack);
    const auto& buffer = context.client.buffers.pixel_pack;
    GLubyte* const bytes = locate(buffer, mask, layout.bytes());
    if (!bytes) return buffer ? context.error(GL_INVALID_OPERATION) : void();

    const PolygonStipplePattern& pattern = context.state.rasterization.polygon_stipple;
    for (std::size_t y = 0; y < Size; ++y) {
        for (std::size_t x = 0; x < Size; ++x) {
            GLubyte& byte = bytes[layout.byte(x, y)];
            const std::uint8_t bit = layout.mask(x);
            byte = static_cast<GLubyte>(pattern[y] & (0x80000000u >> x) ? byte | bit : byte & ~bit);
        }
    }
}

} // namespace ffgpu::gl::api
