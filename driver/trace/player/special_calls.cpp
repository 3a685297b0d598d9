// Commands of a trace that need more than their arguments.

#include "driver/context/current.h"
#include "driver/entry_points/entry.h"
#include "driver/feedback/render_modes.h"
#include "driver/objects/buffer_object.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/objects/renderbuffer.h"
#include "driver/objects/shared_objects.h"
#include "driver/objects/texture_object.h"
#include "driver/trace/player/names.h"
#include "driver/trace/player/player.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ffgpu::trace {
namespace {

constexpr std::uint64_t MaxNames = 1 << 22; // of one call

// A name that the program was given is free: an object that still has it is a leftover.
template <class Table>
void take_name(Table& table, GLuint name) {
    if (table.find(name)) table.remove(name);
    table.reserve(name);
}

template <class Visit>
void for_each_name(const Value& names, Visit&& visit) {
    if (names.kind == ValueKind::Array)
        Call::for_each(names, [&](const Value& name) { visit(to_number<GLuint>(name)); });
}

std::shared_ptr<gl::BufferObject> bound_buffer(const gl::Context& context, GLenum target) {
    const gl::BufferState& buffers = context.client.buffers;
    switch (target) {
    case GL_ARRAY_BUFFER:
        return buffers.array;
    case GL_ELEMENT_ARRAY_BUFFER:
        return context.client.arrays.object->element_buffer;
    case GL_PIXEL_PACK_BUFFER:
        return buffers.pixel_pack;
    case GL_PIXEL_UNPACK_BUFFER:
        return buffers.pixel_unpack;
    case GL_COPY_READ_BUFFER:
        return buffers.copy_read;
    case GL_COPY_WRITE_BUFFER:
        return buffers.copy_write;
    default:
        return nullptr;
    }
}

std::uint64_t positive(const Value& value) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, to_number<std::int64_t>(value)));
}

} // namespace

void TracePlayer::generate_names(const GlCommand* command, Call& call) {
    gl::Context& context = *gl::current_context();
    gl::SharedObjects& shared = context.shared();
    const std::string_view name = without_vendor(command->name);
    for_each_name(call.argument(1), [&](GLuint object) {
        if (name == "GenTextures") take_name(shared.textures, object);
        if (name == "GenBuffers") take_name(shared.buffers, object);
        if (name == "GenRenderbuffers") take_name(shared.renderbuffers, object);
        if (name == "GenFramebuffers") take_name(shared.framebuffers, object);
        if (name == "GenVertexArrays") take_name(context.vertex_array_objects, object);
        if (name == "GenQueries") take_name(context.queries.names, object);
    });
}

void TracePlayer::generate_lists(const GlCommand*, Call& call) {
    const auto first = to_number<GLuint>(call.result());
    const std::uint64_t range = positive(call.argument(0));
    if (first == 0 || range > MaxNames || first > ~GLuint{0} - range) return;
    for (GLuint i = 0; i < range; ++i)
        take_name(gl::current_context()->shared().lists, first + i);
}

// glViewport and glScissor tell how large the window is at least.
void TracePlayer::set_size(const GlCommand* command, Call& call) {
    const auto number = [&](std::size_t i) { return to_number<GLint>(call.argument(i)); };
    windows_.grow(std::int64_t{number(0)} + number(2), std::int64_t{number(1)} + number(3));
    play_plain(*command, call);
}

void TracePlayer::map_buffer(const GlCommand* command, Call& call) {
    play_plain(*command, call);
    const auto buffer = bound_buffer(*gl::current_context(), to_number<GLenum>(call.argument(0)));
    if (buffer) memory_.map(to_number<std::uint64_t>(call.result()), buffer);
}

// memcpy(dest, src, n): the tracer's record of what the program wrote to a mapped buffer.
void TracePlayer::copy_memory(const GlCommand*, Call& call) {
    if (call.argument(1).kind == ValueKind::Blob)
        memory_.write(to_number<std::uint64_t>(call.argument(0)),
                      std::as_const(call).blob(call.argument(1)).bytes());
}

// The room stays until the next glFeedbackBuffer; in feedback mode that is an error and has no
// effect, so that the room must not change.
void TracePlayer::feedback_buffer(const GlCommand*, Call& call) {
    gl::Context& context = *gl::current_context();
    const std::uint64_t size = positive(call.argument(0));
    if (context.render_modes().mode() != GL_RENDER || size > HugeArray) return;
    gl::entry::FeedbackBuffer(static_cast<GLsizei>(size),
                              to_number<GLenum>(call.argument(1)),
                              memory_.feedback(context, size));
}

void TracePlayer::select_buffer(const GlCommand*, Call& call) {
    gl::Context& context = *gl::current_context();
    const std::uint64_t size = positive(call.argument(0));
    if (context.render_modes().mode() != GL_RENDER || size > HugeArray) return;
    gl::entry::SelectBuffer(static_cast<GLsizei>(size), memory_.selection(context, size));
}

// Reading back into a buffer object changes what is drawn from it later.
void TracePlayer::read_into_buffer(const GlCommand* command, Call& call) {
    if (gl::current_context()->client.buffers.pixel_pack) play_plain(*command, call);
}

TracePlayer::Special TracePlayer::find_special(std::string_view name) {
    using P = TracePlayer;
    static const std::map<std::string_view, Special> specials{
        {"glGenTextures", &P::generate_names},
        {"glGenBuffers", &P::generate_names},
        {"glGenQueries", &P::generate_names},
        {"glGenVertexArrays", &P::generate_names},
        {"glGenFramebuffers", &P::generate_names},
        {"glGenRenderbuffers", &P::generate_names},
        {"glGenLists", &P::generate_lists},
        {"glViewport", &P::set_size},
        {"glScissor", &P::set_size},
        {"glVertexPointer", &P::set_array},
        {"glNormalPointer", &P::set_array},
        {"glColorPointer", &P::set_array},
        {"glIndexPointer", &P::set_array},
        {"glEdgeFlagPointer", &P::set_array},
        {"glTexCoordPointer", &P::set_array},
        {"glFogCoordPointer", &P::set_array},
        {"glSecondaryColorPointer", &P::set_array},
        {"glInterleavedArrays", &P::set_array},
        {"glArrayElement", &P::draw_arrays},
        {"glDrawArrays", &P::draw_arrays},
        {"glMultiDrawArrays", &P::multi_draw_arrays},
        {"glDrawElements", &P::draw_elements},
        {"glDrawElementsBaseVertex", &P::draw_elements},
        {"glDrawRangeElements", &P::draw_elements},
        {"glDrawRangeElementsBaseVertex", &P::draw_elements},
        {"glMultiDrawElements", &P::draw_elements},
        {"glMultiDrawElementsBaseVertex", &P::draw_elements},
        {"glMapBuffer", &P::map_buffer},
        {"glMapBufferRange", &P::map_buffer},
        {"memcpy", &P::copy_memory},
        {"glFeedbackBuffer", &P::feedback_buffer},
        {"glSelectBuffer", &P::select_buffer},
        {"glGetTexImage", &P::read_into_buffer},
        {"glGetCompressedTexImage", &P::read_into_buffer},
    };
    const auto found = specials.find(without_vendor(name));
    return found == specials.end() ? nullptr : found->second;
}

} // namespace ffgpu::trace
