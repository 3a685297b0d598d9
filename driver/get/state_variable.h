// What glGet returns: one table, from name to value (GL 1.5, chapter 6). The tables themselves are
// the files of this folder, by chapter of the state.

#pragma once

#include "driver/gl_types.h"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace ffgpu::gl {

class Context;

// A state variable's value, of any type: binary64 holds them all exactly.
struct StateValue {
    // How the value becomes another type (GL 1.5, 6.1.2). Normalized: a colour, a normal or a
    // depth; as an integer 1 is the most positive, -1 the most negative.
    enum class Kind : std::uint8_t { Boolean, Integer, Real, Normalized };

    Kind kind = Kind::Integer;
    std::uint8_t count = 0;
    std::array<double, 16> values{};

    void add(double value) { values[count++] = value; }
};

struct StateVariable {
    GLenum name;
    StateValue (*get)(Context& context);
};

// All of them but the capabilities, in rising order of names.
std::span<const StateVariable> state_variables();

// Looks up capabilities (of glEnable) as well. count 0: no such variable.
StateValue find_state(Context& context, GLenum name);

// Parts of the table.
std::span<const StateVariable> current_variables();
std::span<const StateVariable> array_variables();
std::span<const StateVariable> transform_variables();
std::span<const StateVariable> lighting_variables();
std::span<const StateVariable> rasterization_variables();
std::span<const StateVariable> texture_variables();
std::span<const StateVariable> fragment_variables();
std::span<const StateVariable> framebuffer_variables();
std::span<const StateVariable> pixel_variables();
std::span<const StateVariable> miscellaneous_variables();
std::span<const StateVariable> limit_variables();

// How a table's row makes its value: of numbers, enumerants, flags, or arrays of them.
namespace values {

template <class Number>
void add(StateValue& value, const Number& number) {
    if constexpr (std::is_arithmetic_v<Number>) {
        value.add(static_cast<double>(number));
    } else {
        for (const auto& element : number)
            add(value, element);
    }
}

template <class... Numbers>
StateValue make(StateValue::Kind kind, const Numbers&... numbers) {
    StateValue value{.kind = kind, .count = 0, .values = {}};
    (add(value, numbers), ...);
    return value;
}

template <class... Flags>
StateValue boolean(const Flags&... flags) {
    return make(StateValue::Kind::Boolean, flags...);
}

template <class... Numbers>
StateValue integer(const Numbers&... numbers) {
    return make(StateValue::Kind::Integer, numbers...);
}

template <class... Numbers>
StateValue real(const Numbers&... numbers) {
    return make(StateValue::Kind::Real, numbers...);
}

template <class... Numbers>
StateValue normalized(const Numbers&... numbers) {
    return make(StateValue::Kind::Normalized, numbers...);
}

} // namespace values

// One row: `expression` may use the context as c and its state as s.
#define FFGPU_STATE(name, expression)                                                              \
    StateVariable {                                                                                \
        name, []([[maybe_unused]] Context& c) -> StateValue {                                      \
            [[maybe_unused]] const State& s = c.state;                                             \
            return expression;                                                                     \
        }                                                                                          \
    }

} // namespace ffgpu::gl
