// How each command enters a display list that is being compiled: vertices are assembled, array
// draws are taken apart into vertices, all else becomes a record with copies of its arrays.

#pragma once

#include "driver/commands/command.h"
#include "driver/context/context.h"
#include "driver/entry_points/execute.h"
#include "driver/evaluators/map_points.h"
#include "driver/lists/array_length.h"
#include "driver/lists/list_compiler.h"
#include "driver/lists/recorded_image.h"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace ffgpu::gl {

constexpr bool is_array_draw(Command id) {
    switch (id) {
    case Command::DrawArrays:
    case Command::DrawElements:
    case Command::DrawElementsBaseVertex:
    case Command::DrawElementsInstancedBaseVertex:
    case Command::DrawRangeElements:
    case Command::DrawRangeElementsBaseVertex:
    case Command::MultiDrawArrays:
    case Command::MultiDrawElements:
    case Command::MultiDrawElementsBaseVertex:
        return true;
    default:
        return false;
    }
}

// Commands that may change current attributes without being a vertex's.
constexpr bool changes_current(Command id) {
    return id == Command::CallList || id == Command::CallLists || id == Command::PopAttrib;
}

// Commands whose array may lie in the pixel unpack buffer, as it is: no pixel store applies.
constexpr bool may_read_unpack_buffer(Command id) {
    switch (id) {
    case Command::CompressedTexImage1D:
    case Command::CompressedTexImage2D:
    case Command::CompressedTexImage3D:
    case Command::CompressedTexSubImage1D:
    case Command::CompressedTexSubImage2D:
    case Command::CompressedTexSubImage3D:
    case Command::PixelMapfv:
    case Command::PixelMapuiv:
    case Command::PixelMapusv:
        return true;
    default:
        return false;
    }
}

// A length beyond this is an error's.
constexpr std::int64_t MaxRecordedElements = std::int64_t{1} << 31;

// Elements of the arrays of a command without an image in a client format.
template <Command Id, class... Arguments>
std::int64_t array_elements(Arguments... arguments) {
    if constexpr (ArrayLength<Id>::Known) {
        return ArrayLength<Id>::count(arguments...);
    } else if constexpr (Id == Command::CallLists) {
        return call_lists_bytes(arguments...);
    } else if constexpr (Id == Command::Map1d || Id == Command::Map1f || Id == Command::Map2d ||
                         Id == Command::Map2f) {
        return map_points(arguments...);
    } else {
        static_assert((!std::is_pointer_v<Arguments> && ...), "an array of unknown length");
        return 0;
    }
}

// Bytes of what a pointer points to; 1 for void.
template <class Pointer>
constexpr std::size_t element_bytes() {
    using Element = std::remove_pointer_t<Pointer>;
    if constexpr (std::is_void_v<Element>) {
        return 1;
    } else {
        return sizeof(Element);
    }
}

template <class Argument>
void record_argument(RecordWriter& record, Argument argument, std::int64_t elements) {
    if constexpr (std::is_pointer_v<Argument>) {
        constexpr std::size_t Size = element_bytes<Argument>();
        const bool present = argument && elements >= 0 && elements <= MaxRecordedElements;
        const std::size_t bytes = present ? static_cast<std::size_t>(elements) * Size : 0;
        std::byte* const to = record.array(bytes, present);
        std::copy_n(reinterpret_cast<const std::byte*>(argument), bytes, to);
    } else {
        record.value(argument);
    }
}

// The arguments of a command with an image end with the pointer to it.
template <Command Id, class... Arguments>
void record_image_command(Context& context, RecordWriter& record, Arguments... arguments) {
    const auto pixels = std::get<sizeof...(Arguments) - 1>(std::tuple(arguments...));
    const ImageCopy copy = plan_image_copy(context, ImageOf<Id>::of(arguments...), pixels);
    record.value(copy.store);
    const auto record_one = [&](auto argument) {
        if constexpr (std::is_pointer_v<decltype(argument)>) {
            record_image(record, copy);
        } else {
            record.value(argument);
        }
    };
    (record_one(arguments), ...);
}

template <Command Id, class... Arguments>
void record_command(Context& context, Arguments... arguments) {
    RecordWriter record(context.lists().code(), operation(Id));
    if constexpr (ImageOf<Id>::Known) {
        record_image_command<Id>(context, record, arguments...);
    } else if constexpr (may_read_unpack_buffer(Id)) {
        const std::int64_t elements = array_elements<Id>(arguments...);
        const auto record_one = [&](auto argument) {
            if constexpr (std::is_pointer_v<decltype(argument)>) {
                const auto bytes = static_cast<std::size_t>(std::max<std::int64_t>(0, elements)) *
                                   element_bytes<decltype(argument)>();
                const std::byte* const data = unpack_source(context, argument, bytes);
                record_argument(record, data, static_cast<std::int64_t>(bytes));
            } else {
                record.value(argument);
            }
        };
        (record_one(arguments), ...);
    } else {
        const std::int64_t elements = array_elements<Id>(arguments...);
        (record_argument(record, arguments, elements), ...);
    }
    record.commit();
    if constexpr (changes_current(Id)) context.lists().vertices().forget_current();
}

template <Command Id, CommandClass Class, auto Function, class... Arguments>
void compile(Context& context, Arguments... arguments) {
    if constexpr (Class == CommandClass::Vertex || is_array_draw(Id)) {
        ListVertices& vertices = context.lists().vertices();
        if constexpr (is_array_draw(Id)) {
            if (!vertices.begin_array_draw()) return;
        } else {
            vertices.begin_call();
        }
        const ListVerticesInPlace redirected(context, vertices);
        Function(context, arguments...);
    } else if constexpr (ImageOf<Id>::Known) {
        if (ImageOf<Id>::of(arguments...).is_proxy)
            return execute<CommandClass::Immediate, Function>(context, arguments...);
        record_command<Id>(context, arguments...);
    } else {
        record_command<Id>(context, arguments...);
    }
}

} // namespace ffgpu::gl
