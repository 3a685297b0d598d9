// Materials (GL 1.5, 2.14.2), and their tracking of the current colour (2.14.3).

#include "driver/api/parameters.h"
#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/lower/color_material.h"
#include "driver/vertex/immediate_vertices.h"

namespace ffgpu::gl::api {
namespace {

constexpr Parameter MaterialParameters[] = {
    {GL_AMBIENT, 4, true},
    {GL_DIFFUSE, 4, true},
    {GL_SPECULAR, 4, true},
    {GL_EMISSION, 4, true},
    {GL_AMBIENT_AND_DIFFUSE, 4, true},
    {GL_SHININESS, 1},
    {GL_COLOR_INDEXES, 3},
};

bool is_face(GLenum face) {
    return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK;
}

// Colours that track the current colour keep it.
void set_material(MaterialFace& material, std::uint8_t tracked, GLenum name, const Vec4& values) {
    const auto set = [&](Vec4& color, ColorMaterialBit bit) {
        if (!(tracked & bit)) color = values;
    };
    switch (name) {
    case GL_AMBIENT:
        set(material.ambient, ColorMaterialAmbient);
        break;
    case GL_DIFFUSE:
        set(material.diffuse, ColorMaterialDiffuse);
        break;
    case GL_AMBIENT_AND_DIFFUSE:
        set(material.ambient, ColorMaterialAmbient);
        set(material.diffuse, ColorMaterialDiffuse);
        break;
    case GL_SPECULAR:
        set(material.specular, ColorMaterialSpecular);
        break;
    case GL_EMISSION:
        set(material.emission, ColorMaterialEmission);
        break;
    case GL_SHININESS:
        material.shininess = values[0];
        break;
    default:
        material.color_indexes = {values[0], values[1], values[2]};
    }
}

template <class Number>
void set_materials(Context& context, GLenum face, GLenum name, const Number* params) {
    const Parameter* const parameter = find_parameter(MaterialParameters, name);
    if (!is_face(face) || !parameter) return context.error(GL_INVALID_ENUM);
    const Vec4 values = read_values(*parameter, params);
    if (name == GL_SHININESS && !(values[0] >= 0 && values[0] <= 128))
        return context.error(GL_INVALID_VALUE);

    const LightingState& before = context.state.lighting;
    std::array<MaterialFace, 2> materials = before.materials;
    for (unsigned i = 0; i < 2; ++i) {
        if (face != (i == 0 ? GL_BACK : GL_FRONT))
            set_material(materials[i], tracked_colors(before.color_material, i), name, values);
    }
    if (materials == before.materials) return;
    // Vertices that wait have the old materials, which without lighting does not matter.
    if (before.enable) context.immediate().change_materials(materials);
    context.state.lighting.materials = materials;
    context.dirty.mark(Dirty::Lighting);
}

template <class Number>
void get_material(Context& context, GLenum face, GLenum name, Number* params) {
    const Parameter* const parameter = find_parameter(MaterialParameters, name);
    if ((face != GL_FRONT && face != GL_BACK) || !parameter || name == GL_AMBIENT_AND_DIFFUSE)
        return context.error(GL_INVALID_ENUM);
    LightingState& lighting = context.state.lighting;
    track_color(lighting, context.state.current.of(Attribute::Color));
    const MaterialFace& material = lighting.materials[face == GL_FRONT ? 0 : 1];
    const auto values = [&]() -> Vec4 {
        switch (name) {
        case GL_AMBIENT:
            return material.ambient;
        case GL_DIFFUSE:
            return material.diffuse;
        case GL_SPECULAR:
            return material.specular;
        case GL_EMISSION:
            return material.emission;
        case GL_SHININESS:
            return {material.shininess};
        default:
            return {
                material.color_indexes[0], material.color_indexes[1], material.color_indexes[2], 0};
        }
    };
    write_values(*parameter, values(), params);
}

} // namespace

void Materialf(Context& context, GLenum face, GLenum pname, GLfloat param) {
    set_materials(context, face, pname, Scalar(param).values);
}

void Materiali(Context& context, GLenum face, GLenum pname, GLint param) {
    set_materials(context, face, pname, Scalar(param).values);
}

void Materialfv(Context& context, GLenum face, GLenum pname, const GLfloat* params) {
    set_materials(context, face, pname, params);
}

void Materialiv(Context& context, GLenum face, GLenum pname, const GLint* params) {
    set_materials(context, face, pname, params);
}

void GetMaterialfv(Context& context, GLenum face, GLenum pname, GLfloat* params) {
    get_material(context, face, pname, params);
}

void GetMaterialiv(Context& context, GLenum face, GLenum pname, GLint* params) {
    get_material(context, face, pname, params);
}

void ColorMaterial(Context& context, GLenum face, GLenum mode) {
    const bool is_mode = mode == GL_AMBIENT || mode == GL_DIFFUSE || mode == GL_SPECULAR ||
                         mode == GL_EMISSION || mode == GL_AMBIENT_AND_DIFFUSE;
    if (!is_face(face) || !is_mode) return context.error(GL_INVALID_ENUM);
    LightingState& lighting = context.state.lighting;
    const Vec4& color = context.state.current.of(Attribute::Color);
    track_color(lighting, color); // What is no longer tracked keeps the colour.
    lighting.color_material.face = face;
    lighting.color_material.mode = mode;
    track_color(lighting, color);
    context.dirty.mark(Dirty::Lighting);
}

} // namespace ffgpu::gl::api
