// Calls that must be refused, as data: what tests/driver/error_walk_test.cpp walks.

#pragma once

#include "driver/commands/command.h"
#include "driver/entry_points/entry.h"

#include <span>

namespace ffgpu::gl::error_walk {

struct RefusedCall {
    Command command;
    GLenum error;
    const char* text;
    void (*call)();
};

// Calls that are refused in one situation, which `arrange` brings about in a fresh context.
struct Scene {
    const char* text;
    void (*arrange)();
    std::span<const RefusedCall> calls;
};

std::span<const Scene> state_scenes();
std::span<const Scene> parameter_scenes();
std::span<const Scene> query_scenes();
std::span<const Scene> texture_scenes();
std::span<const Scene> pixel_scenes();
std::span<const Scene> buffer_scenes();
std::span<const Scene> framebuffer_scenes();
std::span<const Scene> drawing_scenes();
std::span<const Scene> list_scenes();

// Arguments that are valid memory; the calls must not get as far as using it.
inline GLfloat zeroes[64] = {};
inline GLfloat minus_ones[4] = {-1, -1, -1, -1};
inline GLfloat floats[64] = {};
inline GLdouble doubles[64] = {};
inline GLint ints[64] = {};
inline GLuint names[64] = {77};
inline GLushort shorts[64] = {};
inline GLubyte bytes[4096] = {};
inline GLboolean flags[64] = {};
inline void* pointers[4] = {bytes, bytes, bytes, bytes};

// RefusedCall of glName(arguments...).
#define REFUSED(error, name, ...)                                                                  \
    RefusedCall {                                                                                  \
        Command::name, error, #name "(" #__VA_ARGS__ ")",                                          \
            [] { static_cast<void>(entry::name(__VA_ARGS__)); }                                    \
    }

} // namespace ffgpu::gl::error_walk
