// glPixelTransfer, glPixelMap, glPixelZoom (GL 1.5, 3.6.3 and 3.6.5).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/images/pixel_memory.h"
#include "driver/limits.h"
#include "driver/math/conversion.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

namespace ffgpu::gl::api {
namespace {

// Null: there is no such map.
std::vector<float>* find_map(Context& context, GLenum map) {
    const GLenum index = map - GL_PIXEL_MAP_I_TO_I;
    auto& maps = context.state.pixel.maps;
    return index < maps.size() ? &maps[index] : nullptr;
}

// I_TO_I and S_TO_S hold indices, the others colours.
bool holds_indices(GLenum map) {
    return map == GL_PIXEL_MAP_I_TO_I || map == GL_PIXEL_MAP_S_TO_S;
}

bool has_index_input(GLenum map) {
    return map <= GL_PIXEL_MAP_I_TO_A;
}

template <class Value>
float entry_of(GLenum map, Value value) {
    const auto real = static_cast<float>(value);
    if (holds_indices(map)) return real;
    if constexpr (std::is_integral_v<Value>) {
        constexpr auto Max = static_cast<double>(std::numeric_limits<Value>::max());
        return static_cast<float>(value / Max);
    } else {
        return clamp_unit(real);
    }
}

template <class Value>
Value value_of(GLenum map, float entry) {
    const auto real = static_cast<double>(entry);
    if constexpr (std::is_integral_v<Value>) {
        constexpr auto Max = static_cast<double>(std::numeric_limits<Value>::max());
        const double scaled = holds_indices(map) ? real : clamp_unit(real) * Max;
        return static_cast<Value>(std::clamp(scaled + 0.5, 0.0, Max));
    } else {
        return static_cast<Value>(entry);
    }
}

template <class Value>
void set_map(Context& context, GLenum map, GLsizei size, const Value* values) {
    std::vector<float>* const entries = find_map(context, map);
    if (!entries) return context.error(GL_INVALID_ENUM);
    if (size < 1 || size > static_cast<GLsizei>(MaxPixelMapTable))
        return context.error(GL_INVALID_VALUE);
    if (has_index_input(map) && !std::has_single_bit(static_cast<unsigned>(size)))
        return context.error(GL_INVALID_VALUE);
    const auto count = static_cast<std::size_t>(size);
    const auto memory = source_memory(context, values, count * sizeof(Value), sizeof(Value));
    if (!memory || !*memory) return;
    const auto* const from = reinterpret_cast<const Value*>(*memory);
    entries->resize(count);
    std::transform(
        from, from + count, entries->begin(), [&](Value value) { return entry_of(map, value); });
}

template <class Value>
void get_map(Context& context, GLenum map, Value* values) {
    const std::vector<float>* const entries = find_map(context, map);
    if (!entries) return context.error(GL_INVALID_ENUM);
    const auto memory =
        destination_memory(context, values, entries->size() * sizeof(Value), sizeof(Value));
    if (!memory || !*memory) return;
    std::transform(entries->begin(),
                   entries->end(),
                   reinterpret_cast<Value*>(*memory),
                   [&](float entry) { return value_of<Value>(map, entry); });
}

} // namespace

void PixelTransferf(Context& context, GLenum pname, GLfloat param) {
    PixelState& pixel = context.state.pixel;
    switch (pname) {
    case GL_MAP_COLOR:
        pixel.map_color = param != 0;
        break;
    case GL_MAP_STENCIL:
        pixel.map_stencil = param != 0;
        break;
    case GL_INDEX_SHIFT:
        pixel.index_shift = round_to_int(static_cast<double>(param));
        break;
    case GL_INDEX_OFFSET:
        pixel.index_offset = round_to_int(static_cast<double>(param));
        break;
    case GL_RED_SCALE:
        pixel.scale[0] = param;
        break;
    case GL_GREEN_SCALE:
        pixel.scale[1] = param;
        break;
    case GL_BLUE_SCALE:
        pixel.scale[2] = param;
        break;
    case GL_ALPHA_SCALE:
        pixel.scale[3] = param;
        break;
    case GL_RED_BIAS:
        pixel.bias[0] = param;
        break;
    case GL_GREEN_BIAS:
        pixel.bias[1] = param;
        break;
    case GL_BLUE_BIAS:
        pixel.bias[2] = param;
        break;
    case GL_ALPHA_BIAS:
        pixel.bias[3] = param;
        break;
    case GL_DEPTH_SCALE:
        pixel.depth_scale = param;
        break;
    case GL_DEPTH_BIAS:
        pixel.depth_bias = param;
        break;
    default:
        context.error(GL_INVALID_ENUM);
    }
}

void PixelTransferi(Context& context, GLenum pname, GLint param) {
    switch (pname) {
    case GL_INDEX_SHIFT:
        context.state.pixel.index_shift = param;
        break;
    case GL_INDEX_OFFSET:
        context.state.pixel.index_offset = param;
        break;
    default:
        PixelTransferf(context, pname, static_cast<GLfloat>(param));
    }
}

void PixelMapfv(Context& context, GLenum map, GLsizei mapsize, const GLfloat* values) {
    set_map(context, map, mapsize, values);
}

void PixelMapuiv(Context& context, GLenum map, GLsizei mapsize, const GLuint* values) {
    set_map(context, map, mapsize, values);
}

void PixelMapusv(Context& context, GLenum map, GLsizei mapsize, const GLushort* values) {
    set_map(context, map, mapsize, values);
}

void GetPixelMapfv(Context& context, GLenum map, GLfloat* values) {
    get_map(context, map, values);
}

void GetPixelMapuiv(Context& context, GLenum map, GLuint* values) {
    get_map(context, map, values);
}

void GetPixelMapusv(Context& context, GLenum map, GLushort* values) {
    get_map(context, map, values);
}

void PixelZoom(Context& context, GLfloat xfactor, GLfloat yfactor) {
    context.state.pixel.zoom_x = xfactor;
    context.state.pixel.zoom_y = yfactor;
}

} // namespace ffgpu::gl::api
