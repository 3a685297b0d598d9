// Initial values against the specification's state tables, and glGet's conversions.

#include "tests/driver/state_fixture.h"

#include <cmath>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::gl {
namespace {

using namespace entry;
using Values = std::vector<double>;

const Values Identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
const Values All32{4294967295.0};

struct Initial {
    GLenum name;
    const char* text;
    Values values;
};
#define INITIAL(name, ...)                                                                         \
    {                                                                                              \
        GL_##name, #name, {                                                                        \
            __VA_ARGS__                                                                            \
        }                                                                                          \
    }

// GL 1.5, tables 6.5 to 6.35, of a context on a double-buffered drawable of 64 x 48 pixels.
const Initial Table[] = {
    // 6.5
    INITIAL(CURRENT_COLOR, 1, 1, 1, 1),
    INITIAL(CURRENT_SECONDARY_COLOR, 0, 0, 0, 1),
    INITIAL(CURRENT_INDEX, 1),
    INITIAL(CURRENT_TEXTURE_COORDS, 0, 0, 0, 1),
    INITIAL(CURRENT_NORMAL, 0, 0, 1),
    INITIAL(CURRENT_FOG_COORD, 0),
    INITIAL(CURRENT_RASTER_POSITION, 0, 0, 0, 1),
    INITIAL(CURRENT_RASTER_DISTANCE, 0),
    INITIAL(CURRENT_RASTER_COLOR, 1, 1, 1, 1),
    INITIAL(CURRENT_RASTER_SECONDARY_COLOR, 0, 0, 0, 1),
    INITIAL(CURRENT_RASTER_INDEX, 1),
    INITIAL(CURRENT_RASTER_TEXTURE_COORDS, 0, 0, 0, 1),
    INITIAL(CURRENT_RASTER_POSITION_VALID, 1),
    INITIAL(EDGE_FLAG, 1),
    // 6.6
    INITIAL(CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0),
    INITIAL(VERTEX_ARRAY, 0),
    INITIAL(VERTEX_ARRAY_SIZE, 4),
    INITIAL(VERTEX_ARRAY_TYPE, GL_FLOAT),
    INITIAL(VERTEX_ARRAY_STRIDE, 0),
    INITIAL(NORMAL_ARRAY, 0),
    INITIAL(NORMAL_ARRAY_TYPE, GL_FLOAT),
    INITIAL(NORMAL_ARRAY_STRIDE, 0),
    INITIAL(FOG_COORD_ARRAY, 0),
    INITIAL(FOG_COORD_ARRAY_TYPE, GL_FLOAT),
    INITIAL(FOG_COORD_ARRAY_STRIDE, 0),
    INITIAL(COLOR_ARRAY, 0),
    INITIAL(COLOR_ARRAY_SIZE, 4),
    INITIAL(COLOR_ARRAY_TYPE, GL_FLOAT),
    INITIAL(COLOR_ARRAY_STRIDE, 0),
    INITIAL(SECONDARY_COLOR_ARRAY, 0),
    INITIAL(SECONDARY_COLOR_ARRAY_SIZE, 3),
    INITIAL(SECONDARY_COLOR_ARRAY_TYPE, GL_FLOAT),
    INITIAL(SECONDARY_COLOR_ARRAY_STRIDE, 0),
    INITIAL(INDEX_ARRAY, 0),
    INITIAL(INDEX_ARRAY_TYPE, GL_FLOAT),
    INITIAL(INDEX_ARRAY_STRIDE, 0),
    INITIAL(TEXTURE_COORD_ARRAY, 0),
    INITIAL(TEXTURE_COORD_ARRAY_SIZE, 4),
    INITIAL(TEXTURE_COORD_ARRAY_TYPE, GL_FLOAT),
    INITIAL(TEXTURE_COORD_ARRAY_STRIDE, 0),
    INITIAL(EDGE_FLAG_ARRAY, 0),
    INITIAL(EDGE_FLAG_ARRAY_STRIDE, 0),
    INITIAL(ARRAY_BUFFER_BINDING, 0),
    INITIAL(VERTEX_ARRAY_BUFFER_BINDING, 0),
    INITIAL(NORMAL_ARRAY_BUFFER_BINDING, 0),
    INITIAL(COLOR_ARRAY_BUFFER_BINDING, 0),
    INITIAL(INDEX_ARRAY_BUFFER_BINDING, 0),
    INITIAL(TEXTURE_COORD_ARRAY_BUFFER_BINDING, 0),
    INITIAL(EDGE_FLAG_ARRAY_BUFFER_BINDING, 0),
    INITIAL(SECONDARY_COLOR_ARRAY_BUFFER_BINDING, 0),
    INITIAL(FOG_COORD_ARRAY_BUFFER_BINDING, 0),
    INITIAL(ELEMENT_ARRAY_BUFFER_BINDING, 0),
    // 6.7
    {GL_MODELVIEW_MATRIX, "MODELVIEW_MATRIX", Identity},
    {GL_PROJECTION_MATRIX, "PROJECTION_MATRIX", Identity},
    {GL_TEXTURE_MATRIX, "TEXTURE_MATRIX", Identity},
    {GL_TRANSPOSE_MODELVIEW_MATRIX, "TRANSPOSE_MODELVIEW_MATRIX", Identity},
    {GL_TRANSPOSE_PROJECTION_MATRIX, "TRANSPOSE_PROJECTION_MATRIX", Identity},
    {GL_TRANSPOSE_TEXTURE_MATRIX, "TRANSPOSE_TEXTURE_MATRIX", Identity},
    INITIAL(VIEWPORT, 0, 0, 64, 48),
    INITIAL(DEPTH_RANGE, 0, 1),
    INITIAL(MODELVIEW_STACK_DEPTH, 1),
    INITIAL(PROJECTION_STACK_DEPTH, 1),
    INITIAL(TEXTURE_STACK_DEPTH, 1),
    INITIAL(MATRIX_MODE, GL_MODELVIEW),
    INITIAL(NORMALIZE, 0),
    INITIAL(RESCALE_NORMAL, 0),
    INITIAL(CLIP_PLANE0, 0),
    INITIAL(CLIP_PLANE5, 0),
    // 6.8
    INITIAL(FOG_COLOR, 0, 0, 0, 0),
    INITIAL(FOG_INDEX, 0),
    INITIAL(FOG_DENSITY, 1),
    INITIAL(FOG_START, 0),
    INITIAL(FOG_END, 1),
    INITIAL(FOG_MODE, GL_EXP),
    INITIAL(FOG, 0),
    INITIAL(FOG_COORD_SRC, GL_FRAGMENT_DEPTH),
    INITIAL(FOG_DISTANCE_MODE_NV, GL_EYE_PLANE_ABSOLUTE_NV),
    INITIAL(COLOR_SUM, 0),
    INITIAL(SHADE_MODEL, GL_SMOOTH),
    // 6.9
    INITIAL(LIGHTING, 0),
    INITIAL(COLOR_MATERIAL, 0),
    INITIAL(COLOR_MATERIAL_PARAMETER, GL_AMBIENT_AND_DIFFUSE),
    INITIAL(COLOR_MATERIAL_FACE, GL_FRONT_AND_BACK),
    INITIAL(LIGHT_MODEL_AMBIENT, 0.2f, 0.2f, 0.2f, 1),
    INITIAL(LIGHT_MODEL_LOCAL_VIEWER, 0),
    INITIAL(LIGHT_MODEL_TWO_SIDE, 0),
    INITIAL(LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR),
    INITIAL(LIGHT0, 0),
    INITIAL(LIGHT7, 0),
    // 6.11
    INITIAL(POINT_SIZE, 1),
    INITIAL(POINT_SMOOTH, 0),
    INITIAL(POINT_SIZE_MIN, 0),
    INITIAL(POINT_SIZE_MAX, 256),
    INITIAL(POINT_FADE_THRESHOLD_SIZE, 1),
    INITIAL(POINT_DISTANCE_ATTENUATION, 1, 0, 0),
    INITIAL(POINT_SPRITE, 0),
    INITIAL(LINE_WIDTH, 1),
    INITIAL(LINE_SMOOTH, 0),
    INITIAL(LINE_STIPPLE_PATTERN, 0xffff),
    INITIAL(LINE_STIPPLE_REPEAT, 1),
    INITIAL(LINE_STIPPLE, 0),
    INITIAL(CULL_FACE, 0),
    INITIAL(CULL_FACE_MODE, GL_BACK),
    INITIAL(FRONT_FACE, GL_CCW),
    INITIAL(POLYGON_SMOOTH, 0),
    INITIAL(POLYGON_MODE, GL_FILL, GL_FILL),
    INITIAL(POLYGON_OFFSET_FACTOR, 0),
    INITIAL(POLYGON_OFFSET_UNITS, 0),
    INITIAL(POLYGON_OFFSET_POINT, 0),
    INITIAL(POLYGON_OFFSET_LINE, 0),
    INITIAL(POLYGON_OFFSET_FILL, 0),
    INITIAL(POLYGON_STIPPLE, 0),
    // 6.12
    INITIAL(MULTISAMPLE, 1),
    INITIAL(SAMPLE_ALPHA_TO_COVERAGE, 0),
    INITIAL(SAMPLE_ALPHA_TO_ONE, 0),
    INITIAL(SAMPLE_COVERAGE, 0),
    INITIAL(SAMPLE_COVERAGE_VALUE, 1),
    INITIAL(SAMPLE_COVERAGE_INVERT, 0),
    // 6.13
    INITIAL(TEXTURE_1D, 0),
    INITIAL(TEXTURE_2D, 0),
    INITIAL(TEXTURE_3D, 0),
    INITIAL(TEXTURE_CUBE_MAP, 0),
    INITIAL(TEXTURE_RECTANGLE_ARB, 0),
    INITIAL(TEXTURE_BINDING_1D, 0),
    INITIAL(TEXTURE_BINDING_2D, 0),
    INITIAL(TEXTURE_BINDING_3D, 0),
    INITIAL(TEXTURE_BINDING_CUBE_MAP, 0),
    INITIAL(TEXTURE_BINDING_RECTANGLE_ARB, 0),
    INITIAL(ACTIVE_TEXTURE, GL_TEXTURE0),
    INITIAL(TEXTURE_GEN_S, 0),
    INITIAL(TEXTURE_GEN_Q, 0),
    // 6.18
    INITIAL(SCISSOR_TEST, 0),
    INITIAL(SCISSOR_BOX, 0, 0, 64, 48),
    INITIAL(ALPHA_TEST, 0),
    INITIAL(ALPHA_TEST_FUNC, GL_ALWAYS),
    INITIAL(ALPHA_TEST_REF, 0),
    INITIAL(STENCIL_TEST, 0),
    INITIAL(STENCIL_FUNC, GL_ALWAYS),
    {GL_STENCIL_VALUE_MASK, "STENCIL_VALUE_MASK", All32},
    INITIAL(STENCIL_REF, 0),
    INITIAL(STENCIL_FAIL, GL_KEEP),
    INITIAL(STENCIL_PASS_DEPTH_FAIL, GL_KEEP),
    INITIAL(STENCIL_PASS_DEPTH_PASS, GL_KEEP),
    INITIAL(STENCIL_TEST_TWO_SIDE_EXT, 0),
    INITIAL(ACTIVE_STENCIL_FACE_EXT, GL_FRONT),
    INITIAL(STENCIL_BACK_FUNC_ATI, GL_ALWAYS),
    INITIAL(STENCIL_BACK_FAIL_ATI, GL_KEEP),
    INITIAL(STENCIL_BACK_PASS_DEPTH_FAIL_ATI, GL_KEEP),
    INITIAL(STENCIL_BACK_PASS_DEPTH_PASS_ATI, GL_KEEP),
    INITIAL(DEPTH_TEST, 0),
    INITIAL(DEPTH_FUNC, GL_LESS),
    INITIAL(DEPTH_BOUNDS_TEST_EXT, 0),
    INITIAL(DEPTH_BOUNDS_EXT, 0, 1),
    // 6.19
    INITIAL(BLEND, 0),
    INITIAL(BLEND_SRC, GL_ONE),
    INITIAL(BLEND_DST, GL_ZERO),
    INITIAL(BLEND_SRC_RGB, GL_ONE),
    INITIAL(BLEND_SRC_ALPHA, GL_ONE),
    INITIAL(BLEND_DST_RGB, GL_ZERO),
    INITIAL(BLEND_DST_ALPHA, GL_ZERO),
    INITIAL(BLEND_EQUATION, GL_FUNC_ADD),
    INITIAL(BLEND_EQUATION_ALPHA_EXT, GL_FUNC_ADD),
    INITIAL(BLEND_COLOR, 0, 0, 0, 0),
    INITIAL(DITHER, 1),
    INITIAL(INDEX_LOGIC_OP, 0),
    INITIAL(COLOR_LOGIC_OP, 0),
    INITIAL(LOGIC_OP_MODE, GL_COPY),
    // 6.20
    INITIAL(DRAW_BUFFER, GL_BACK),
    {GL_INDEX_WRITEMASK, "INDEX_WRITEMASK", All32},
    INITIAL(COLOR_WRITEMASK, 1, 1, 1, 1),
    INITIAL(DEPTH_WRITEMASK, 1),
    {GL_STENCIL_WRITEMASK, "STENCIL_WRITEMASK", All32},
    INITIAL(COLOR_CLEAR_VALUE, 0, 0, 0, 0),
    INITIAL(INDEX_CLEAR_VALUE, 0),
    INITIAL(DEPTH_CLEAR_VALUE, 1),
    INITIAL(STENCIL_CLEAR_VALUE, 0),
    INITIAL(ACCUM_CLEAR_VALUE, 0, 0, 0, 0),
    INITIAL(FRAMEBUFFER_BINDING, 0),
    INITIAL(READ_FRAMEBUFFER_BINDING, 0),
    INITIAL(RENDERBUFFER_BINDING, 0),
    // 6.21
    INITIAL(UNPACK_SWAP_BYTES, 0),
    INITIAL(UNPACK_LSB_FIRST, 0),
    INITIAL(UNPACK_IMAGE_HEIGHT, 0),
    INITIAL(UNPACK_SKIP_IMAGES, 0),
    INITIAL(UNPACK_ROW_LENGTH, 0),
    INITIAL(UNPACK_SKIP_ROWS, 0),
    INITIAL(UNPACK_SKIP_PIXELS, 0),
    INITIAL(UNPACK_ALIGNMENT, 4),
    INITIAL(PACK_SWAP_BYTES, 0),
    INITIAL(PACK_LSB_FIRST, 0),
    INITIAL(PACK_IMAGE_HEIGHT, 0),
    INITIAL(PACK_SKIP_IMAGES, 0),
    INITIAL(PACK_ROW_LENGTH, 0),
    INITIAL(PACK_SKIP_ROWS, 0),
    INITIAL(PACK_SKIP_PIXELS, 0),
    INITIAL(PACK_ALIGNMENT, 4),
    INITIAL(PIXEL_PACK_BUFFER_BINDING, 0),
    INITIAL(PIXEL_UNPACK_BUFFER_BINDING, 0),
    // 6.22, 6.23
    INITIAL(MAP_COLOR, 0),
    INITIAL(MAP_STENCIL, 0),
    INITIAL(INDEX_SHIFT, 0),
    INITIAL(INDEX_OFFSET, 0),
    INITIAL(RED_SCALE, 1),
    INITIAL(GREEN_SCALE, 1),
    INITIAL(BLUE_SCALE, 1),
    INITIAL(ALPHA_SCALE, 1),
    INITIAL(DEPTH_SCALE, 1),
    INITIAL(RED_BIAS, 0),
    INITIAL(GREEN_BIAS, 0),
    INITIAL(BLUE_BIAS, 0),
    INITIAL(ALPHA_BIAS, 0),
    INITIAL(DEPTH_BIAS, 0),
    INITIAL(ZOOM_X, 1),
    INITIAL(ZOOM_Y, 1),
    INITIAL(PIXEL_MAP_I_TO_I_SIZE, 1),
    INITIAL(PIXEL_MAP_S_TO_S_SIZE, 1),
    INITIAL(PIXEL_MAP_I_TO_R_SIZE, 1),
    INITIAL(PIXEL_MAP_I_TO_G_SIZE, 1),
    INITIAL(PIXEL_MAP_I_TO_B_SIZE, 1),
    INITIAL(PIXEL_MAP_I_TO_A_SIZE, 1),
    INITIAL(PIXEL_MAP_R_TO_R_SIZE, 1),
    INITIAL(PIXEL_MAP_G_TO_G_SIZE, 1),
    INITIAL(PIXEL_MAP_B_TO_B_SIZE, 1),
    INITIAL(PIXEL_MAP_A_TO_A_SIZE, 1),
    INITIAL(READ_BUFFER, GL_BACK),
    // 6.28
    INITIAL(MAP1_VERTEX_3, 0),
    INITIAL(MAP2_COLOR_4, 0),
    INITIAL(MAP1_GRID_DOMAIN, 0, 1),
    INITIAL(MAP2_GRID_DOMAIN, 0, 1, 0, 1),
    INITIAL(MAP1_GRID_SEGMENTS, 1),
    INITIAL(MAP2_GRID_SEGMENTS, 1, 1),
    INITIAL(AUTO_NORMAL, 0),
    // 6.30
    INITIAL(PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE),
    INITIAL(POINT_SMOOTH_HINT, GL_DONT_CARE),
    INITIAL(LINE_SMOOTH_HINT, GL_DONT_CARE),
    INITIAL(POLYGON_SMOOTH_HINT, GL_DONT_CARE),
    INITIAL(FOG_HINT, GL_DONT_CARE),
    INITIAL(GENERATE_MIPMAP_HINT, GL_DONT_CARE),
    INITIAL(TEXTURE_COMPRESSION_HINT, GL_DONT_CARE),
    // 6.33, of the drawable
    INITIAL(AUX_BUFFERS, 0),
    INITIAL(RGBA_MODE, 1),
    INITIAL(INDEX_MODE, 0),
    INITIAL(DOUBLEBUFFER, 1),
    INITIAL(STEREO, 0),
    INITIAL(SAMPLE_BUFFERS, 0),
    INITIAL(SAMPLES, 0),
    INITIAL(RED_BITS, 8),
    INITIAL(GREEN_BITS, 8),
    INITIAL(BLUE_BITS, 8),
    INITIAL(ALPHA_BITS, 8),
    INITIAL(INDEX_BITS, 0),
    INITIAL(DEPTH_BITS, 24),
    INITIAL(STENCIL_BITS, 8),
    INITIAL(ACCUM_RED_BITS, 16),
    INITIAL(ACCUM_ALPHA_BITS, 16),
    // 6.35
    INITIAL(LIST_BASE, 0),
    INITIAL(LIST_INDEX, 0),
    INITIAL(LIST_MODE, 0),
    INITIAL(ATTRIB_STACK_DEPTH, 0),
    INITIAL(CLIENT_ATTRIB_STACK_DEPTH, 0),
    INITIAL(NAME_STACK_DEPTH, 0),
    INITIAL(RENDER_MODE, GL_RENDER),
    INITIAL(SELECTION_BUFFER_SIZE, 0),
    INITIAL(FEEDBACK_BUFFER_SIZE, 0),
    INITIAL(FEEDBACK_BUFFER_TYPE, GL_2D),
};

// GL 1.5, tables 6.31 and 6.32.
struct Minimum {
    GLenum name;
    const char* text;
    double at_least;
};
#define MINIMUM(name, value)                                                                       \
    { GL_##name, #name, value }
const Minimum Minima[] = {
    MINIMUM(MAX_LIGHTS, 8),
    MINIMUM(MAX_CLIP_PLANES, 6),
    MINIMUM(MAX_MODELVIEW_STACK_DEPTH, 32),
    MINIMUM(MAX_PROJECTION_STACK_DEPTH, 2),
    MINIMUM(MAX_TEXTURE_STACK_DEPTH, 2),
    MINIMUM(SUBPIXEL_BITS, 4),
    MINIMUM(MAX_3D_TEXTURE_SIZE, 16),
    MINIMUM(MAX_TEXTURE_SIZE, 64),
    MINIMUM(MAX_TEXTURE_LOD_BIAS, 2),
    MINIMUM(MAX_CUBE_MAP_TEXTURE_SIZE, 16),
    MINIMUM(MAX_PIXEL_MAP_TABLE, 32),
    MINIMUM(MAX_NAME_STACK_DEPTH, 64),
    MINIMUM(MAX_LIST_NESTING, 64),
    MINIMUM(MAX_EVAL_ORDER, 8),
    MINIMUM(MAX_VIEWPORT_DIMS, 64),
    MINIMUM(MAX_ATTRIB_STACK_DEPTH, 16),
    MINIMUM(MAX_CLIENT_ATTRIB_STACK_DEPTH, 16),
    MINIMUM(ALIASED_POINT_SIZE_RANGE, 1),
    MINIMUM(SMOOTH_POINT_SIZE_RANGE, 1),
    MINIMUM(SMOOTH_POINT_SIZE_GRANULARITY, 0),
    MINIMUM(ALIASED_LINE_WIDTH_RANGE, 1),
    MINIMUM(SMOOTH_LINE_WIDTH_RANGE, 1),
    MINIMUM(SMOOTH_LINE_WIDTH_GRANULARITY, 0),
    MINIMUM(MAX_ELEMENTS_INDICES, 1),
    MINIMUM(MAX_ELEMENTS_VERTICES, 1),
    MINIMUM(NUM_COMPRESSED_TEXTURE_FORMATS, 0),
    MINIMUM(MAX_TEXTURE_UNITS, 2),
    MINIMUM(MAX_TEXTURE_MAX_ANISOTROPY_EXT, 2),
    MINIMUM(MAX_RECTANGLE_TEXTURE_SIZE_ARB, 64),
    MINIMUM(MAX_RENDERBUFFER_SIZE, 1),
    MINIMUM(MAX_COLOR_ATTACHMENTS, 1),
    MINIMUM(MAX_SAMPLES, 1),
};

} // namespace

TEST_CASE("Every state variable starts with the value of the specification's tables") {
    StateFixture f;
    for (const Initial& initial : Table) {
        INFO(initial.text);
        const StateValue value = find_state(f.context(), initial.name);
        CHECK(Values(value.values.begin(), value.values.begin() + value.count) == initial.values);
        GLdouble doubles[17];
        std::fill_n(doubles, 17, -77.0);
        GetDoublev(initial.name, doubles);
        CHECK(Values(doubles, doubles + initial.values.size()) == initial.values);
        CHECK(doubles[initial.values.size()] == -77.0);
        GLboolean booleans[17];
        GetBooleanv(initial.name, booleans);
        CHECK((booleans[0] == GL_TRUE) == (initial.values[0] != 0));
        CHECK(GetError() == GL_NO_ERROR);
    }
}

TEST_CASE("Every limit is at least what the specification asks for") {
    StateFixture f;
    for (const Minimum& minimum : Minima) {
        INFO(minimum.text);
        GLdouble values[16] = {-1};
        GetDoublev(minimum.name, values);
        CHECK(values[0] >= minimum.at_least);
    }
    CHECK(get_int(GL_SUBPIXEL_BITS) == 8);
    CHECK(get_int(GL_MAX_TEXTURE_SIZE) == 4096);
    CHECK(get_int(GL_MAX_TEXTURE_UNITS) == 8);
}

TEST_CASE("No name stands twice in the table of state variables") {
    const auto all = state_variables();
    for (std::size_t i = 1; i < all.size(); ++i)
        CHECK(all[i - 1].name < all[i].name);
    for (const StateVariable& variable : all)
        CHECK(find_capability(variable.name) == nullptr);
}

TEST_CASE("A name that glGet does not know is an invalid enumerant and writes nothing") {
    StateFixture f;
    GLint value = 42;
    GetIntegerv(0xdead, &value);
    CHECK(GetError() == GL_INVALID_ENUM);
    CHECK(value == 42);
    CHECK(IsEnabled(0xdead) == GL_FALSE);
    CHECK(GetError() == GL_INVALID_ENUM);
    Enable(GL_LIGHT0 + 8);
    CHECK(GetError() == GL_INVALID_ENUM);
}

TEST_CASE("Colours and depths become the full range of integers, other floats are rounded") {
    StateFixture f;
    ClearColor(1, 0, 0.5f, 1);
    GLint color[4];
    GetIntegerv(GL_COLOR_CLEAR_VALUE, color);
    CHECK(color[0] == std::numeric_limits<GLint>::max());
    CHECK((color[1] == 0 || color[1] == -1));
    CHECK(std::abs(color[2] - (1 << 30)) <= 1);
    Normal3f(-1, 0, 1);
    GLint normal[3];
    GetIntegerv(GL_CURRENT_NORMAL, normal);
    CHECK(normal[0] == std::numeric_limits<GLint>::min());
    CHECK(normal[2] == std::numeric_limits<GLint>::max());
    GLint range[2];
    GetIntegerv(GL_DEPTH_RANGE, range);
    CHECK(range[1] == std::numeric_limits<GLint>::max());

    PointSize(2.5f);
    CHECK(get_int(GL_POINT_SIZE) == 3);
    LineWidth(2.4f);
    CHECK(get_int(GL_LINE_WIDTH) == 2);
    CHECK(get_int(GL_STENCIL_VALUE_MASK) == -1);
    StencilMask(0x80000001u);
    CHECK(get_int(GL_STENCIL_WRITEMASK) == static_cast<GLint>(0x80000001u));
    CHECK(get_floats(GL_STENCIL_WRITEMASK, 1)[0] == 2147483648.0f);
}

TEST_CASE("Capabilities are told by glIsEnabled and by glGet alike") {
    StateFixture f;
    for (const Capability& capability : capabilities()) {
        for (GLenum i = 0; i < capability.count; ++i) {
            const GLenum name = capability.name + i;
            INFO("capability " << std::hex << name);
            const bool before = IsEnabled(name) == GL_TRUE;
            CHECK(before == (name == GL_DITHER || name == GL_MULTISAMPLE));
            before ? Disable(name) : Enable(name);
            CHECK((IsEnabled(name) == GL_TRUE) == !before);
            CHECK((get_int(name) == 1) == !before);
            CHECK(GetError() == GL_NO_ERROR);
        }
    }
}

TEST_CASE("Texture capabilities belong to the active unit") {
    StateFixture f;
    ActiveTexture(GL_TEXTURE3);
    Enable(GL_TEXTURE_2D);
    Enable(GL_TEXTURE_GEN_T);
    ActiveTexture(GL_TEXTURE0);
    CHECK(IsEnabled(GL_TEXTURE_2D) == GL_FALSE);
    CHECK(IsEnabled(GL_TEXTURE_GEN_T) == GL_FALSE);
    ActiveTexture(GL_TEXTURE3);
    CHECK(IsEnabled(GL_TEXTURE_2D) == GL_TRUE);
    CHECK(IsEnabled(GL_TEXTURE_GEN_T) == GL_TRUE);
}

TEST_CASE("The compressed formats listed are as many as their number says") {
    StateFixture f;
    GLint formats[16] = {};
    GetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, formats);
    CHECK(get_int(GL_NUM_COMPRESSED_TEXTURE_FORMATS) == 4);
    CHECK(formats[0] == GL_COMPRESSED_RGB_S3TC_DXT1_EXT);
    CHECK(formats[3] == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
}

TEST_CASE("A drawable without back, alpha, depth and accumulation buffers says so") {
    StateFixture f({.double_buffer = false,
                    .alpha = false,
                    .depth_bits = 0,
                    .stencil_bits = 0,
                    .accumulation = false});
    CHECK(get_int(GL_DOUBLEBUFFER) == 0);
    CHECK(get_int(GL_DRAW_BUFFER) == GL_FRONT);
    CHECK(get_int(GL_READ_BUFFER) == GL_FRONT);
    for (const GLenum name : {GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS, GL_ACCUM_GREEN_BITS})
        CHECK(get_int(name) == 0);
}

TEST_CASE("The strings name version 1.5 and each extension once") {
    StateFixture f;
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(GetString(name)));
    };
    CHECK(text(GL_VERSION).rfind("1.5 ", 0) == 0);
    CHECK(text(GL_VENDOR) == "ffgpu");
    CHECK(!text(GL_RENDERER).empty());
    const std::string extensions = text(GL_EXTENSIONS);
    CHECK(extensions.find(" GL_ARB_multitexture ") != std::string::npos);
    CHECK(extensions.find("  ") == std::string::npos);
    CHECK(GetString(GL_SHADING_LANGUAGE_VERSION) == nullptr);
    CHECK(GetError() == GL_INVALID_ENUM);
}

} // namespace ffgpu::gl
