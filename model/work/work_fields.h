// Registers and commands as flat lists of named numbers: how a work file keeps them, so that a
// reader finds each by its name and not by its place.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ffgpu::work {

using FieldValues = std::vector<std::uint32_t>;

// Calls visit(owner, field, width) for each field of a Registers, or of a command, in one order.
template <class Object, class Visit>
void for_each_field(Object& object, Visit&& visit) {
    if constexpr (std::is_same_v<std::remove_cv_t<Object>, Registers>) {
        Registers::visit(object, [&](auto& reg) {
            using Register = std::remove_cvref_t<decltype(reg)>;
            Register::visit(reg, [&](FieldName name, auto& field, unsigned width = 32) {
                visit(Register::Name, name, field, width);
            });
        });
    } else {
        std::remove_cv_t<Object>::visit(object,
                                        [&](FieldName name, auto& field, unsigned width = 32) {
                                            visit("command", name, field, width);
                                        });
    }
}

// Each name once: "targets.width" is followed by "targets.width#1".
template <class Object>
std::vector<std::string> field_names() {
    std::vector<std::string> names;
    std::map<std::string, unsigned> seen;
    const Object object{};
    for_each_field(object, [&](const char* owner, FieldName name, const auto&, unsigned) {
        std::string full = std::string(owner) + '.' + name.text();
        const unsigned before = seen[full]++;
        names.push_back(before == 0 ? full : full + '#' + std::to_string(before));
    });
    return names;
}

template <class Object>
void field_values(const Object& object, FieldValues& values) {
    static const std::size_t count = [&object] {
        std::size_t fields = 0;
        for_each_field(object, [&](const char*, FieldName, const auto&, unsigned) { ++fields; });
        return fields;
    }();
    values.resize(count);
    std::uint32_t* to = values.data();
    for_each_field(object, [&](const char*, FieldName, const auto& field, unsigned) {
        *to++ = field_bits(field);
    });
}

template <class Object>
void set_fields(std::span<const std::uint32_t> values, Object& object) {
    std::size_t at = 0;
    for_each_field(object, [&](const char*, FieldName, auto& field, unsigned width) {
        using Field = std::remove_reference_t<decltype(field)>;
        const std::uint32_t bits = values[at++] & ~std::uint32_t{0} >> (32 - width);
        if constexpr (std::is_same_v<Field, float>) {
            field = std::bit_cast<float>(bits);
        } else if constexpr (std::is_signed_v<Field>) {
            const unsigned spare = 32 - width; // Sign extension.
            field = static_cast<Field>(static_cast<std::int32_t>(bits << spare) >> spare);
        } else {
            field = static_cast<Field>(bits);
        }
    });
}

} // namespace ffgpu::work
