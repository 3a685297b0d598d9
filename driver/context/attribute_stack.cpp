#include "driver/context/attribute_stack.h"

#include "driver/context/context.h"
#include "driver/context/saved_attributes.h"
#include "driver/limits.h"
#include "driver/lists/list_compiler.h"
#include "driver/lower/color_material.h"
#include "driver/objects/framebuffer_object.h"
#include "driver/state/capabilities.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

// The draw buffers or read buffer in force: the window's or the bound framebuffer object's.
DrawBufferList& draw_buffers(FramebufferState& state) {
    return state.draw_object ? state.draw_object->draw_buffers : state.draw_buffers;
}

GLenum& read_buffer(FramebufferState& state) {
    return state.read_object ? state.read_object->read_buffer : state.read_buffer;
}

// A buffer that was saved while another kind of framebuffer was bound does not exist now.
bool is_of(const std::shared_ptr<FramebufferObject>& object, GLenum buffer) {
    return buffer == GL_NONE || (object != nullptr) == (buffer >= GL_COLOR_ATTACHMENT0);
}

// GL_COORD_REPLACE of all units, a bit each: the point group's alone (ARB_point_sprite).
std::uint8_t coord_replace_of(const TextureState& texture) {
    unsigned bits = 0;
    for (unsigned i = 0; i < TextureUnits; ++i)
        bits |= texture.units[i].environment.coord_replace ? 1u << i : 0u;
    return static_cast<std::uint8_t>(bits);
}

void set_coord_replace(std::uint8_t bits, TextureState& texture) {
    for (unsigned i = 0; i < TextureUnits; ++i)
        texture.units[i].environment.coord_replace = bits >> i & 1;
}

void save_point(Context& context, SavedAttributes& saved) {
    saved.point = context.state.rasterization.point;
    saved.coord_replace = coord_replace_of(context.state.texture);
}

void restore_point(const SavedAttributes& saved, Context& context) {
    context.state.rasterization.point = saved.point;
    set_coord_replace(saved.coord_replace, context.state.texture);
    context.dirty.mark(Dirty::Primitive);
}

void save_pixel(Context& context, SavedAttributes& saved) {
    saved.pixel = context.state.pixel;
    saved.read_buffer = read_buffer(context.state.framebuffer);
}

void restore_pixel(const SavedAttributes& saved, Context& context) {
    auto maps = std::move(context.state.pixel.maps);
    context.state.pixel = saved.pixel;
    context.state.pixel.maps = std::move(maps);
    FramebufferState& framebuffer = context.state.framebuffer;
    if (is_of(framebuffer.read_object, saved.read_buffer))
        read_buffer(framebuffer) = saved.read_buffer;
}

void save_lighting(Context& context, SavedAttributes& saved) {
    track_color(context.state.lighting, context.state.current.of(Attribute::Color));
    saved.lighting = context.state.lighting;
}

void restore_lighting(const SavedAttributes& saved, Context& context) {
    context.state.lighting = saved.lighting;
    context.dirty.mark(Dirty::Lighting);
    context.dirty.mark(Dirty::Primitive); // the shade model
    context.dirty.mark(Dirty::Fragment);  // the colour sum
}

void save_enables(Context& context, SavedAttributes& saved) {
    track_color(context.state.lighting, context.state.current.of(Attribute::Color));
    saved.capabilities.clear();
    for_each_capability_flag(context.state, [&](bool flag) { saved.capabilities.push_back(flag); });
}

void restore_enables(const SavedAttributes& saved, Context& context) {
    track_color(context.state.lighting, context.state.current.of(Attribute::Color));
    auto next = saved.capabilities.begin();
    for_each_capability_flag(context.state, [&](bool& flag) { flag = *next++; });
    context.dirty = DirtyGroups::all();
}

void save_color_buffer(Context& context, SavedAttributes& saved) {
    FramebufferState& framebuffer = context.state.framebuffer;
    saved.alpha_test = context.state.fragment.alpha_test;
    saved.blend = context.state.fragment.blend;
    saved.draw_buffers = draw_buffers(framebuffer);
    saved.color_mask = framebuffer.color_mask;
    saved.index_mask = framebuffer.index_mask;
    saved.clear_color = framebuffer.clear_color;
    saved.clear_index = framebuffer.clear_index;
}

void restore_color_buffer(const SavedAttributes& saved, Context& context) {
    FramebufferState& framebuffer = context.state.framebuffer;
    context.state.fragment.alpha_test = saved.alpha_test;
    context.state.fragment.blend = saved.blend;
    if (std::all_of(saved.draw_buffers.begin(), saved.draw_buffers.end(), [&](GLenum buffer) {
            return is_of(framebuffer.draw_object, buffer);
        }))
        draw_buffers(framebuffer) = saved.draw_buffers;
    framebuffer.color_mask = saved.color_mask;
    framebuffer.index_mask = saved.index_mask;
    framebuffer.clear_color = saved.clear_color;
    framebuffer.clear_index = saved.clear_index;
    context.dirty.mark(Dirty::Fragment);
    context.dirty.mark(Dirty::Targets);
}

void save_list(Context& context, SavedAttributes& saved) {
    saved.list_base = context.lists().base;
}

void restore_list(const SavedAttributes& saved, Context& context) {
    context.lists().base = saved.list_base;
}

void save_texture(Context& context, SavedAttributes& saved) {
    saved.textures = save_textures(context.state.texture);
}

void restore_texture(const SavedAttributes& saved, Context& context) {
    const std::uint8_t coord_replace = coord_replace_of(context.state.texture);
    restore_textures(*saved.textures, context.state.texture);
    set_coord_replace(coord_replace, context.state.texture);
    context.dirty.mark(Dirty::Textures);
    context.dirty.mark(Dirty::Environments);
    context.dirty.mark(Dirty::TexGen);
}

// An object that was deleted since has its name again (APPLE_vertex_array_object).
void revive(NameTable<VertexArrayObject>& objects,
            const std::shared_ptr<VertexArrayObject>& object) {
    if (object->name != 0 && !objects.find(object->name)) objects.set(object->name, object);
}

struct Group {
    GLbitfield bit;
    void (*save)(Context& context, SavedAttributes& saved);
    void (*restore)(const SavedAttributes& saved, Context& context);
};

// A group whose saved member holds all of `part` of the state.
#define WHOLE(bit, member, part, ...)                                                              \
    Group {                                                                                        \
        bit, [](Context& c, SavedAttributes& saved) { saved.member = c.state.part; },              \
            [](const SavedAttributes& saved, Context& c) {                                         \
                c.state.part = saved.member;                                                       \
                for (const Dirty group : std::initializer_list<Dirty>{__VA_ARGS__})                \
                    c.dirty.mark(group);                                                           \
            }                                                                                      \
    }

// In the order of restoring: tracked materials follow the current colour, and what GL_ENABLE_BIT
// shares with another group is the same in both.
constexpr Group Groups[] = {
    WHOLE(GL_CURRENT_BIT, current, current, Dirty::Current),
    {GL_POINT_BIT, save_point, restore_point},
    WHOLE(GL_LINE_BIT, line, rasterization.line, Dirty::Primitive),
    WHOLE(GL_POLYGON_BIT, polygon, rasterization.polygon, Dirty::Primitive),
    WHOLE(GL_POLYGON_STIPPLE_BIT, polygon_stipple, rasterization.polygon_stipple, Dirty::Primitive),
    {GL_PIXEL_MODE_BIT, save_pixel, restore_pixel},
    {GL_LIGHTING_BIT, save_lighting, restore_lighting},
    WHOLE(GL_FOG_BIT, fog, fragment.fog, Dirty::Fragment),
    WHOLE(GL_DEPTH_BUFFER_BIT, depth, fragment.depth, Dirty::Fragment),
    WHOLE(GL_ACCUM_BUFFER_BIT, clear_accum, framebuffer.clear_accum),
    WHOLE(GL_STENCIL_BUFFER_BIT, stencil, fragment.stencil, Dirty::Fragment),
    WHOLE(GL_VIEWPORT_BIT, viewport, transform.viewport, Dirty::Viewport),
    WHOLE(GL_TRANSFORM_BIT,
          transform,
          transform.group,
          Dirty::Matrices,
          Dirty::ClipPlanes,
          Dirty::Viewport),
    {GL_ENABLE_BIT, save_enables, restore_enables},
    {GL_COLOR_BUFFER_BIT, save_color_buffer, restore_color_buffer},
    WHOLE(GL_HINT_BIT, hint, hint),
    WHOLE(GL_EVAL_BIT, evaluator, evaluator.settings),
    {GL_LIST_BIT, save_list, restore_list},
    {GL_TEXTURE_BIT, save_texture, restore_texture},
    WHOLE(GL_SCISSOR_BIT, scissor, fragment.scissor, Dirty::Viewport),
    WHOLE(GL_MULTISAMPLE_BIT, multisample, rasterization.multisample, Dirty::Fragment),
};

#undef WHOLE

} // namespace

AttributeStack::AttributeStack() = default;
AttributeStack::~AttributeStack() = default;

bool AttributeStack::push(Context& context, GLbitfield mask) {
    if (depth_ == AttributeStackDepth) return false;
    if (depth_ == saved_.size()) saved_.push_back(std::make_unique<SavedAttributes>());
    SavedAttributes& saved = *saved_[depth_];
    for (const Group& group : Groups) {
        if (mask & group.bit) group.save(context, saved);
    }
    saved.mask = mask;
    ++depth_;
    return true;
}

bool AttributeStack::pop(Context& context) {
    if (depth_ == 0) return false;
    SavedAttributes& saved = *saved_[--depth_];
    for (const Group& group : Groups) {
        if (saved.mask & group.bit) group.restore(saved, context);
    }
    saved.textures.reset(); // Textures must not live on in an unused entry.
    return true;
}

bool AttributeStack::push_client(Context& context, GLbitfield mask) {
    if (client_depth_ == ClientAttributeStackDepth) return false;
    if (client_depth_ == saved_client_.size())
        saved_client_.push_back(std::make_unique<SavedClientAttributes>());
    SavedClientAttributes& saved = *saved_client_[client_depth_];
    saved = {.mask = mask,
             .pixel_store = context.client.pixel_store,
             .buffers = context.client.buffers,
             .arrays = {}};
    if (mask & GL_CLIENT_VERTEX_ARRAY_BIT) saved.arrays = save(context.client.arrays);
    ++client_depth_;
    return true;
}

bool AttributeStack::pop_client(Context& context) {
    if (client_depth_ == 0) return false;
    SavedClientAttributes& saved = *saved_client_[--client_depth_];
    BufferState& buffers = context.client.buffers;
    if (saved.mask & GL_CLIENT_PIXEL_STORE_BIT) {
        context.client.pixel_store = saved.pixel_store;
        buffers.pixel_pack = saved.buffers.pixel_pack;
        buffers.pixel_unpack = saved.buffers.pixel_unpack;
    }
    if (saved.mask & GL_CLIENT_VERTEX_ARRAY_BIT) {
        restore(context.client.arrays, *saved.arrays);
        buffers.array = saved.buffers.array;
        revive(context.vertex_array_objects, context.client.arrays.object);
    }
    saved = {};
    return true;
}

} // namespace ffgpu::gl
