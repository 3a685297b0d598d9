// Commands of the form glThing{if}[v](..., pname, params): what a pname stands for, so that each
// form reads no more than its values, and one function sets or gets them all.

#pragma once

#include "driver/gl_types.h"
#include "driver/math/conversion.h"
#include "model/device/registers/geometry.h"

#include <cstdint>
#include <span>

namespace ffgpu::gl {

struct Parameter {
    GLenum name;
    std::uint8_t count;    // of values, 1 to 4
    bool is_color = false; // Integers stand for [-1, 1].
};

// The parameter of a form without v. Drivers take it for the first component of a colour or
// position, too, whose others are then 0, and programs rely on it.
template <class Number>
struct Scalar {
    explicit Scalar(Number value)
        : values{value, 0, 0, 0} {}
    Number values[4];
};

// Null: there is no such parameter (GL_INVALID_ENUM).
inline const Parameter* find_parameter(std::span<const Parameter> all, GLenum name) {
    for (const Parameter& parameter : all) {
        if (parameter.name == name) return &parameter;
    }
    return nullptr;
}

inline Vec4 read_values(const Parameter& parameter, const GLfloat* values) {
    Vec4 result{};
    for (std::size_t i = 0; i < parameter.count; ++i)
        result[i] = values[i];
    return result;
}

inline Vec4 read_values(const Parameter& parameter, const GLint* values) {
    Vec4 result{};
    for (std::size_t i = 0; i < parameter.count; ++i)
        result[i] =
            parameter.is_color ? normalized_from_int(values[i]) : static_cast<float>(values[i]);
    return result;
}

inline void write_values(const Parameter& parameter, const Vec4& values, GLfloat* to) {
    for (std::size_t i = 0; i < parameter.count; ++i)
        to[i] = values[i];
}

inline void write_values(const Parameter& parameter, const Vec4& values, GLint* to) {
    for (std::size_t i = 0; i < parameter.count; ++i) {
        const double value = static_cast<double>(values[i]);
        to[i] = parameter.is_color ? int_from_normalized(value) : round_to_int(value);
    }
}

// An enumerant that came as a float. What is none becomes GL_INVALID_ENUM's sure cause, ~0.
inline GLenum to_enum(float value) {
    return value >= 0 && value < 65536 ? static_cast<GLenum>(value) : ~GLenum{0};
}

} // namespace ffgpu::gl
