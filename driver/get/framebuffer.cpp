// Framebuffer control, its objects and its formats (GL 1.5, state tables 6.20, 6.21 and 6.33).

#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/get/state_variable.h"
#include "driver/limits.h"
#include "driver/objects/framebuffer_object.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {
namespace {

template <class Object>
GLuint name(const std::shared_ptr<Object>& object) {
    return object ? object->name : 0;
}

static_assert(ColorTargets == 8, "each GL_DRAW_BUFFERi has a row below");
GLenum draw_buffer(const FramebufferState& state, unsigned i) {
    return state.draw_object ? state.draw_object->draw_buffers[i] : state.draw_buffers[i];
}

GLenum read_buffer(const FramebufferState& state) {
    return state.read_object ? state.read_object->read_buffer : state.read_buffer;
}

// The drawable that is drawn to; null while a framebuffer object is.
const Drawable* window(Context& context) {
    return context.state.framebuffer.draw_object ? nullptr : context.draw_drawable();
}

ComponentBits window_bits(const PixelFormat& format) {
    ComponentBits bits{};
    bits.red = bits.green = bits.blue = 8;
    bits.alpha = format.alpha ? 8 : 0;
    bits.depth = format.depth_bits;
    bits.stencil = format.stencil_bits;
    return bits;
}

ComponentBits object_bits(FramebufferObject& object) {
    ComponentBits bits{};
    if (const Attachment* const color = object.find(object.draw_buffers[0]); color && *color)
        bits = component_bits(color->format());
    bits.depth = object.depth ? component_bits(object.depth.format()).depth : std::uint8_t{0};
    bits.stencil =
        object.stencil ? component_bits(object.stencil.format()).stencil : std::uint8_t{0};
    return bits;
}

ComponentBits draw_bits(Context& context) {
    if (const auto& object = context.state.framebuffer.draw_object) return object_bits(*object);
    const Drawable* const drawable = context.draw_drawable();
    return drawable ? window_bits(drawable->format()) : ComponentBits{};
}

unsigned accumulation_bits(Context& context) {
    const Drawable* const drawable = window(context);
    return drawable && drawable->format().accumulation ? AccumulationBits : 0;
}

// Of the draw framebuffer; 0 where it is single-sampled (EXT_framebuffer_multisample).
GLsizei draw_samples(Context& context) {
    if (const auto& object = context.state.framebuffer.draw_object) return samples(*object);
    const Drawable* const drawable = context.draw_drawable();
    return drawable && drawable->format().samples > 1 ? drawable->format().samples : 0;
}

// EXT_framebuffer_sRGB: of a window always, of an object if an image that is drawn to holds codes.
bool is_srgb_capable(Context& context) {
    const auto& object = context.state.framebuffer.draw_object;
    if (!object) return window(context) != nullptr;
    return std::ranges::any_of(object->draw_buffers, [&object](GLenum buffer) {
        const Attachment* const color = object->find(buffer);
        return color && *color && color->format().srgb;
    });
}

} // namespace

std::span<const StateVariable> framebuffer_variables() {
    using namespace values;
    static constexpr std::array Table{
        FFGPU_STATE(GL_DRAW_BUFFER, integer(draw_buffer(s.framebuffer, 0))),
        FFGPU_STATE(GL_DRAW_BUFFER0, integer(draw_buffer(s.framebuffer, 0))),
        FFGPU_STATE(GL_DRAW_BUFFER1, integer(draw_buffer(s.framebuffer, 1))),
        FFGPU_STATE(GL_DRAW_BUFFER2, integer(draw_buffer(s.framebuffer, 2))),
        FFGPU_STATE(GL_DRAW_BUFFER3, integer(draw_buffer(s.framebuffer, 3))),
        FFGPU_STATE(GL_DRAW_BUFFER4, integer(draw_buffer(s.framebuffer, 4))),
        FFGPU_STATE(GL_DRAW_BUFFER5, integer(draw_buffer(s.framebuffer, 5))),
        FFGPU_STATE(GL_DRAW_BUFFER6, integer(draw_buffer(s.framebuffer, 6))),
        FFGPU_STATE(GL_DRAW_BUFFER7, integer(draw_buffer(s.framebuffer, 7))),
        FFGPU_STATE(GL_READ_BUFFER, integer(read_buffer(s.framebuffer))),
        FFGPU_STATE(GL_INDEX_WRITEMASK, integer(s.framebuffer.index_mask)),
        FFGPU_STATE(GL_COLOR_WRITEMASK, boolean(s.framebuffer.color_mask)),
        FFGPU_STATE(GL_DEPTH_WRITEMASK, boolean(s.fragment.depth.write_mask)),
        FFGPU_STATE(GL_COLOR_CLEAR_VALUE, normalized(s.framebuffer.clear_color)),
        FFGPU_STATE(GL_INDEX_CLEAR_VALUE, real(s.framebuffer.clear_index)),
        FFGPU_STATE(GL_DEPTH_CLEAR_VALUE, normalized(s.fragment.depth.clear_value)),
        FFGPU_STATE(GL_STENCIL_CLEAR_VALUE, integer(s.fragment.stencil.clear_value)),
        FFGPU_STATE(GL_ACCUM_CLEAR_VALUE, normalized(s.framebuffer.clear_accum)),
        FFGPU_STATE(GL_DRAW_FRAMEBUFFER_BINDING, integer(name(s.framebuffer.draw_object))),
        FFGPU_STATE(GL_READ_FRAMEBUFFER_BINDING, integer(name(s.framebuffer.read_object))),
        FFGPU_STATE(GL_RENDERBUFFER_BINDING, integer(name(s.framebuffer.renderbuffer))),
        FFGPU_STATE(GL_RED_BITS, integer(draw_bits(c).red)),
        FFGPU_STATE(GL_GREEN_BITS, integer(draw_bits(c).green)),
        FFGPU_STATE(GL_BLUE_BITS, integer(draw_bits(c).blue)),
        FFGPU_STATE(GL_ALPHA_BITS, integer(draw_bits(c).alpha)),
        FFGPU_STATE(GL_DEPTH_BITS, integer(draw_bits(c).depth)),
        FFGPU_STATE(GL_STENCIL_BITS, integer(draw_bits(c).stencil)),
        FFGPU_STATE(GL_INDEX_BITS, integer(0)),
        FFGPU_STATE(GL_ACCUM_RED_BITS, integer(accumulation_bits(c))),
        FFGPU_STATE(GL_ACCUM_GREEN_BITS, integer(accumulation_bits(c))),
        FFGPU_STATE(GL_ACCUM_BLUE_BITS, integer(accumulation_bits(c))),
        FFGPU_STATE(GL_ACCUM_ALPHA_BITS, integer(accumulation_bits(c))),
        FFGPU_STATE(GL_FRAMEBUFFER_SRGB_CAPABLE_EXT, boolean(is_srgb_capable(c))),
        FFGPU_STATE(GL_RGBA_MODE, boolean(true)),
        FFGPU_STATE(GL_INDEX_MODE, boolean(false)),
        FFGPU_STATE(GL_STEREO, boolean(false)),
        FFGPU_STATE(GL_DOUBLEBUFFER, boolean(window(c) && window(c)->format().double_buffer)),
        FFGPU_STATE(GL_AUX_BUFFERS, integer(0)),
        FFGPU_STATE(GL_SAMPLE_BUFFERS, integer(draw_samples(c) > 0 ? 1 : 0)),
        FFGPU_STATE(GL_SAMPLES, integer(draw_samples(c))),
    };
    return Table;
}

} // namespace ffgpu::gl
