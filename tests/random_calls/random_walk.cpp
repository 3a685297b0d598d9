#include "tests/random_calls/random_walk.h"

#include "driver/entry_points/entry.h"
#include "driver/lists/list_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <tuple>
#include <utility>

namespace ffgpu::gl {
namespace {

struct CommandInfo {
    const char* name;
    CommandClass command_class;
};

constexpr CommandInfo Commands[] = {
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    {"gl" #name, CommandClass::command_class},
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
};

constexpr unsigned CommandCount = static_cast<unsigned>(Command::Count);

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool is_bound(GLenum binding) {
    GLint name = 0;
    entry::GetIntegerv(binding, &name);
    return name != 0;
}

// The binding that makes a command's pointer an offset into a buffer; 0: it never is one.
GLenum buffer_binding(std::string_view command, const std::string& parameter, bool is_const) {
    if (contains(command, "Buffer")) return 0;
    if (parameter == "indices") return GL_ELEMENT_ARRAY_BUFFER_BINDING;
    if (parameter == "pointer") return GL_ARRAY_BUFFER_BINDING;
    for (const char* const part : {"Image", "Pixels", "Bitmap", "Stipple", "PixelMap"})
        if (contains(command, part))
            return is_const ? GL_PIXEL_UNPACK_BUFFER_BINDING : GL_PIXEL_PACK_BUFFER_BINDING;
    return 0;
}

template <class Words>
void fill(Words& words, std::size_t bytes, std::mt19937& random) {
    words.resize(bytes / sizeof(words[0]));
    for (auto& word : words)
        word = static_cast<std::remove_reference_t<decltype(word)>>(random() % 64);
}

} // namespace

WalkMemory::WalkMemory() {
    std::mt19937 random(1);
    fill(small_integers, WalkMemoryBytes, random);
    fill(output, WalkMemoryBytes, random);
    fill(floats, WalkMemoryBytes, random);
    fill(doubles, WalkMemoryBytes, random);
    for (float& value : floats)
        value = (value - 24) / 16;
    for (double& value : doubles)
        value = (value - 24) / 16;
    pointers.assign(256, small_integers.data());
}

template <class T>
void print(const T& value) {
    if constexpr (std::is_pointer_v<T>)
        std::cerr << ' ' << static_cast<const void*>(value);
    else
        std::cerr << ' ' << +value;
}

// Calls a command with random arguments.
template <class... Arguments>
struct Caller {
    template <class Result>
    static void
    call(RandomWalk& walk, const RandomWalk::Call& call, Result (*command)(Arguments...)) {
        const auto arguments = draw(walk, call, std::index_sequence_for<Arguments...>());
        if (walk.verbose) {
            std::cerr << call.name;
            std::apply([](const auto&... value) { (print(value), ...); }, arguments);
            std::cerr << std::endl;
        }
        std::apply(command, arguments);
    }

    // In the order of the braces: the first argument first.
    template <std::size_t... Index>
    static std::tuple<Arguments...>
    draw(RandomWalk& walk, const RandomWalk::Call& call, std::index_sequence<Index...>) {
        return std::tuple<Arguments...>{walk.argument<Arguments>(call, Index)...};
    }
};

template <class Result, class... Arguments>
void call_randomly(RandomWalk& walk, const auto& call, Result (*command)(Arguments...)) {
    Caller<Arguments...>::call(walk, call, command);
}

GLuint RandomWalk::enumerant(const RegistryParameter& parameter) {
    // Few commands have an effect without a buffer, and most of the group came later.
    constexpr GLuint Buffers[] = {
        GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER};
    const bool is_buffer =
        std::find(parameter.values.begin(), parameter.values.end(), GLuint{GL_ARRAY_BUFFER}) !=
        parameter.values.end();
    if (is_buffer && !one_in(16)) return Buffers[below(std::size(Buffers))];
    if (parameter.values.empty() || one_in(32)) return below(0x9000);
    const auto any = [&] {
        return parameter.values[below(static_cast<unsigned>(parameter.values.size()))];
    };
    if (parameter.type != "GLbitfield") return any();
    return one_in(3) ? any() : any() | any() | any();
}

std::int64_t RandomWalk::integer(const Call& call, const RegistryParameter& parameter) {
    if (contains(call.name, "PixelStore")) return below(17);
    if (!parameter.values.empty() && !one_in(8)) return enumerant(parameter);
    if (parameter.name == "param" && one_in(2))
        return registry_
            .parameter_values[below(static_cast<unsigned>(registry_.parameter_values.size()))];
    if (parameter.name == "level" && !one_in(8)) return below(6);
    if (parameter.name == "border") return one_in(6);
    if (parameter.name == "basevertex") return below(9);
    if (parameter.type == "GLuint" && !one_in(6)) return below(8);
    // Extremes only where they name no place that is read, and no number of vertices.
    const bool is_free = !call.has_pointer && !contains(call.name, "Draw") &&
                         !contains(call.name, "Element") && !contains(call.name, "EvalMesh");
    constexpr std::int64_t Extremes[] = {std::numeric_limits<std::int32_t>::max(),
                                         std::numeric_limits<std::int32_t>::min(),
                                         65536,
                                         4097,
                                         -70000};
    if (is_free && one_in(24)) return Extremes[below(std::size(Extremes))];
    constexpr std::int64_t Usual[] = {0, 1, 2, 3, 4, 5, 7, 8, 16, 17, 32, 33, 64, 4, 8, 16};
    return one_in(24) ? -1 : Usual[below(std::size(Usual))];
}

double RandomWalk::number(const Call& call, const RegistryParameter& parameter) {
    if (contains(call.name, "PixelStore")) return below(17);
    if (parameter.name == "param" && one_in(2))
        return registry_
            .parameter_values[below(static_cast<unsigned>(registry_.parameter_values.size()))];
    constexpr double Rare[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               1e30,
                               -1e30,
                               1e-30,
                               70000};
    if (one_in(48)) return Rare[below(std::size(Rare))];
    return plain_number();
}

double RandomWalk::plain_number() {
    constexpr double Usual[] = {0, 1, -1, 0.5, 2, 8};
    if (one_in(2)) return Usual[below(std::size(Usual))];
    return (static_cast<double>(below(4096)) - 2048) / 1024;
}

const void*
RandomWalk::pointer(const Call& call, const RegistryParameter& parameter, bool is_const) {
    // What it points to may be places in a buffer; it itself is the program's own.
    if (contains(call.name, "MultiDrawElements") && parameter.name == "indices")
        return memory_.pointers.data();
    const GLenum binding = buffer_binding(call.name, parameter.name, is_const);
    if (binding != 0 && is_bound(binding))
        return reinterpret_cast<const void*>(std::uintptr_t{4} * below(64));
    if (!is_const) return memory_.output.data();
    if (parameter.type == "GLfloat" || parameter.type == "GLclampf") return memory_.floats.data();
    if (parameter.type == "GLdouble" || parameter.type == "GLclampd") return memory_.doubles.data();
    if (parameter.name == "pointer" && !one_in(3)) return memory_.floats.data();
    return memory_.small_integers.data();
}

// What would leave the bounds of OpenGL, or of patience.
bool RandomWalk::is_left_out(Context& context, unsigned command) const {
    const std::string_view name = Commands[command].name;
    if (context.lists().name() != 0 && contains(name, "CallList")) return true;
    // Arrays that lose their buffer would read at its offsets in the program's own memory.
    if (contains(name, "DeleteBuffers")) return true;
    // What a buffer holds may be large as an index.
    const bool elements = contains(name, "Elements") || name == "glArrayElement";
    return elements && context.vertex_phase == VertexPhase::Idle &&
           is_bound(GL_ELEMENT_ARRAY_BUFFER_BINDING);
}

void RandomWalk::call(Context& context, unsigned command) {
    const CommandInfo& info = Commands[command];
    const auto found = registry_.commands.find(info.name);
    if (found == registry_.commands.end() || is_left_out(context, command)) return;
    bool has_pointer = false;
    for (const RegistryParameter& parameter : found->second)
        has_pointer = has_pointer || parameter.is_pointer;
    const Call random{context, info.name, found->second, has_pointer};
    unsigned number = 0;
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    if (number++ == command) call_randomly(*this, random, &entry::name);
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    if (context.take_error() == GL_NO_ERROR) ++accepted_[command];
}

void RandomWalk::primitive(Context& context) {
    static const std::vector<unsigned> vertex_commands = [] {
        std::vector<unsigned> all;
        for (unsigned i = 0; i < CommandCount; ++i)
            if (Commands[i].command_class == CommandClass::Vertex &&
                std::string_view(Commands[i].name) != "glBegin")
                all.push_back(i);
        return all;
    }();
    entry::Begin(below(10));
    for (unsigned i = 0; i < 24; ++i) {
        call(context, vertex_commands[below(static_cast<unsigned>(vertex_commands.size()))]);
        if (one_in(2)) entry::Vertex3d(plain_number(), plain_number(), plain_number());
    }
    entry::End();
}

void RandomWalk::step(Context& context) {
    if (one_in(10)) return primitive(context);
    if (context.vertex_phase == VertexPhase::Inside && one_in(4)) return entry::End();
    if (one_in(50)) return entry::EndList();
    call(context, below(CommandCount));
}

void RandomWalk::settle() {
    entry::End();
    entry::EndList();
    entry::RenderMode(GL_RENDER);
    entry::BindFramebufferEXT(GL_FRAMEBUFFER_EXT, 0);
    entry::BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    entry::PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    entry::PixelStorei(GL_PACK_ROW_LENGTH, 0);
    entry::PixelStorei(GL_PACK_SKIP_ROWS, 0);
    entry::PixelStorei(GL_PACK_SKIP_PIXELS, 0);
    entry::PixelStorei(GL_PACK_ALIGNMENT, 1);
    entry::Disable(GL_SCISSOR_TEST);
}

} // namespace ffgpu::gl
