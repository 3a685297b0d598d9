// The values of the contract's enumerations and their names, from the enumerations themselves.
// A command stream may come from a file: from another release, or damaged.

#pragma once

#include "model/device/layout/register.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ffgpu {

// "ffgpu::FogMode::Exp2" of that value; of a number without enumerator "(ffgpu::FogMode)4".
template <auto Value>
constexpr std::string_view enumerator_text() {
    constexpr std::string_view Before = "Value = ";
    const std::string_view text = __PRETTY_FUNCTION__;
    const std::size_t begin = text.find(Before) + Before.size();
    return text.substr(begin, text.find_first_of(";]", begin) - begin);
}

constexpr std::string_view last_part(std::string_view text) {
    return text.substr(text.rfind(':') + 1);
}

// "FogMode"
template <class Enum>
constexpr std::string_view enumeration_name() {
    const std::string_view text = enumerator_text<static_cast<Enum>(0)>();
    return last_part(text.substr(0, text.rfind("::")));
}

// Fields of enumerations are at most that wide.
constexpr unsigned MostEnumeratorBits = 5;

// "Off", "Linear", "Exp", "Exp2"; then empty. Enumerators count from 0 without a gap.
template <class Enum>
constexpr auto EnumeratorNames = []<std::size_t... I>(std::index_sequence<I...>) {
    std::array<std::string_view, sizeof...(I)> names{enumerator_text<static_cast<Enum>(I)>()...};
    bool ended = false;
    for (std::string_view& name : names) {
        const bool is_name = name[0] != '(' && !(name[0] >= '0' && name[0] <= '9');
        name = last_part(name);
        ended = ended || !is_name || name == "Count";
        if (ended) name = {};
    }
    return names;
}
(std::make_index_sequence<1u << MostEnumeratorBits>{});

template <class Enum>
constexpr std::size_t EnumeratorCount = [] {
    std::size_t count = 0;
    while (count < EnumeratorNames<Enum>.size() && !EnumeratorNames<Enum>[count].empty())
        ++count;
    return count;
}();

// The name of the first field of a register or command that holds no value of its kind.
template <class Packed>
constexpr std::optional<FieldName> find_bad_enumerator(const Packed& packed) {
    std::optional<FieldName> bad;
    Packed::visit(packed, [&bad](FieldName name, const auto& field, unsigned = 32) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (std::is_enum_v<Field>)
            if (!bad && static_cast<std::size_t>(field) >= EnumeratorCount<Field>) bad = name;
    });
    return bad;
}

} // namespace ffgpu
