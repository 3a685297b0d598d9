// The table of GL commands by name, made from the one list of entry points: how to call each with
// the values of a trace.

#pragma once

#include "driver/trace/player/arguments.h"

#include <string_view>

namespace ffgpu::trace {

// Where a command's addresses are offsets, if a buffer object is bound there.
enum class OffsetInto : std::uint8_t { Nothing, VertexBuffer, IndexBuffer, PixelUnpack, PixelPack };

struct GlCommand {
    using AnyFunction = void (*)();

    std::string_view name; // without "gl"
    AnyFunction function;  // ffgpu::gl::entry::Name
    // Calls `function` with the arguments as its parameters' types; returns its result as a number.
    std::uint64_t (*call)(AnyFunction function, Arguments& arguments);
    ArraySize array_size = nullptr;
    OffsetInto offset_into = OffsetInto::Nothing;
};

// By the name as in the API ("glVertex3f"); null where the driver has no such command.
const GlCommand* find_gl_command(std::string_view name);

} // namespace ffgpu::trace
