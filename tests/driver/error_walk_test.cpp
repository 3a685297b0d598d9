// Every command with arguments or in situations that it must refuse: the error is OpenGL's, and
// nothing else happens. The lists are the files error_walk_*.cpp.

#include "driver/objects/texture_object.h"
#include "tests/driver/error_walk.h"
#include "tests/driver/state_fixture.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::gl::error_walk {
namespace {

struct NamedCommand {
    Command command;
    CommandClass command_class;
    std::string name;
    void (*call)(); // with zeroes and with pointers to a little memory
};

alignas(16) std::byte some_memory[65536];

template <class Argument>
Argument plain_argument() {
    if constexpr (std::is_pointer_v<Argument>) {
        return reinterpret_cast<Argument>(some_memory);
    } else {
        return Argument{};
    }
}

template <class Result, class... Arguments>
void call_plainly(Result (*function)(Arguments...) noexcept) {
    static_cast<void>(function(plain_argument<Arguments>()...));
}

const NamedCommand Commands[] = {
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    {Command::name, CommandClass::command_class, #name, [] {                                       \
         call_plainly(static_cast<result(*) parameters noexcept>(entry::name));                    \
     }},
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
};

// The bytes an object is stored in: a refused call does not write one of them.
template <class Object>
std::string storage(const Object& object) {
    std::string bytes(sizeof object, '\0');
    std::memcpy(bytes.data(), static_cast<const void*>(&object), sizeof object);
    return bytes;
}

// All that a refused call must leave alone: the variables of glGet, the storage of the whole state
// and of what it refers to.
struct Everything {
    std::map<GLenum, std::vector<double>> variables;
    std::string state, client, array_object, queries;
    std::vector<std::vector<float>> maps;
    std::vector<TextureParameters> textures;
    std::size_t commands, register_writes;

    bool operator==(const Everything&) const = default;
};

Everything take_everything(StateFixture& f) {
    const Context& context = f.context();
    Everything all{.variables = f.snapshot(),
                   .state = storage(context.state),
                   .client = storage(context.client),
                   .array_object = storage(*context.client.arrays.object),
                   .queries = storage(context.queries),
                   .maps = {},
                   .textures = {},
                   .commands = f.device.commands.size(),
                   .register_writes = f.device.written.size()};
    for (const auto& map : context.state.pixel.maps)
        all.maps.push_back(map);
    for (const auto* maps : {&context.state.evaluator.map1, &context.state.evaluator.map2}) {
        for (const EvaluatorMap& map : *maps)
            all.maps.push_back(map.points);
    }
    for (const TextureUnit& unit : context.state.texture.units) {
        for (const auto& texture : unit.bound)
            all.textures.push_back(texture->parameters);
    }
    return all;
}

std::vector<Scene> all_scenes() {
    std::vector<Scene> all;
    for (const auto part : {state_scenes(),
                            parameter_scenes(),
                            query_scenes(),
                            texture_scenes(),
                            pixel_scenes(),
                            buffer_scenes(),
                            framebuffer_scenes(),
                            drawing_scenes(),
                            list_scenes()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

// Commands that take any argument outside glBegin and glEnd: numbers of all values, names of
// objects that need not be.
bool takes_anything(const NamedCommand& command) {
    static const char* const prefixes[] = {
        "BindVertexArrayAPPLE",
        "BlendColor",
        "ClearAccum",
        "ClearColor",
        "ClearDepth",
        "ClearIndex",
        "ClearStencil",
        "ColorMask",
        "DepthMask",
        "DepthRange",
        "EvalCoord",
        "EvalPoint",
        "Finish",
        "Flush",
        "GetError",
        "IndexMask",
        "InitNames",
        "IsBuffer",
        "IsFramebuffer",
        "IsList",
        "IsQuery",
        "IsRenderbuffer",
        "IsTexture",
        "IsVertexArray",
        "LineStipple",
        "ListBase",
        "LoadIdentity",
        "LoadMatrix",
        "LoadTransposeMatrix",
        "MultMatrix",
        "MultTransposeMatrix",
        "PassThrough",
        "PixelZoom",
        "PolygonOffset",
        "PrimitiveRestartIndexNV",
        "RasterPos",
        "Rect",
        "Rotate",
        "SampleCoverage",
        "Scale",
        "StencilMask",
        "Translate",
        "WindowPos",
        "Color3",
        "Color4",
        "EdgeFlag",
        "FogCoord",
        "Index",
        "MultiTexCoord",
        "Normal3",
        "SecondaryColor3",
        "TexCoord1",
        "TexCoord2",
        "TexCoord3",
        "TexCoord4",
        "Vertex2",
        "Vertex3",
        "Vertex4",
    };
    if (command.name.find("Pointer") != std::string::npos) return false;
    return std::any_of(std::begin(prefixes), std::end(prefixes), [&](const char* prefix) {
        return command.name.rfind(prefix, 0) == 0;
    });
}

} // namespace

TEST_CASE("Each call of the error walk is refused with its error, and nothing is written") {
    for (const Scene& scene : all_scenes()) {
        StateFixture f;
        scene.arrange();
        REQUIRE(entry::GetError() == GL_NO_ERROR);
        for (const RefusedCall& refused : scene.calls) {
            INFO(scene.text << ": gl" << refused.text);
            const Everything before = take_everything(f);
            refused.call();
            CHECK(entry::GetError() == refused.error);
            CHECK(entry::GetError() == GL_NO_ERROR);
            const Everything after = take_everything(f);
            CHECK(after.variables == before.variables);
            CHECK((after == before));
        }
    }
}

TEST_CASE("The error walk has every command that can refuse its arguments") {
    std::set<Command> walked;
    for (const Scene& scene : all_scenes()) {
        for (const RefusedCall& refused : scene.calls)
            walked.insert(refused.command);
    }
    for (const NamedCommand& command : Commands) {
        INFO("gl" << command.name);
        CHECK((walked.count(command.command) == 1 || takes_anything(command)));
    }
}

TEST_CASE("Between glBegin and glEnd every command but those of vertices is refused") {
    for (const NamedCommand& command : Commands) {
        if (command.command_class != CommandClass::Immediate &&
            command.command_class != CommandClass::Compiled)
            continue;
        if (command.command == Command::GetError) continue;
        INFO("gl" << command.name);
        StateFixture f;
        entry::Begin(GL_TRIANGLES);
        const Everything before = take_everything(f);
        command.call();
        const Everything after = take_everything(f);
        entry::End();
        CHECK(entry::GetError() == GL_INVALID_OPERATION);
        CHECK((after == before));
    }
}

TEST_CASE("glGetError between glBegin and glEnd is an error itself, and returns zero") {
    StateFixture f;
    entry::PointSize(-1);
    CHECK(entry::GetError() == GL_INVALID_VALUE);
    entry::Begin(GL_POINTS);
    CHECK(entry::GetError() == GL_NO_ERROR);
    entry::End();
    CHECK(entry::GetError() == GL_INVALID_OPERATION);
}

} // namespace ffgpu::gl::error_walk
