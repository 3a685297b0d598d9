#include "driver/entry_points/list_player.h"

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/entry_points/compile.h"
#include "driver/entry_points/execute.h"
#include "driver/limits.h"
#include "driver/lists/block_draw.h"
#include "driver/lists/record.h"
#include "driver/lists/recorded_image.h"
#include "driver/objects/shared_objects.h"
#include "driver/vertex/immediate_vertices.h"

#include <array>
#include <optional>
#include <tuple>

namespace ffgpu::gl {

namespace {

using Play = void (*)(Context&, RecordReader&);

// Carries out a command with the arguments of its record.
template <Command Id, CommandClass Class, auto Function>
struct PlayCommand;

template <Command Id,
          CommandClass Class,
          class... Arguments,
          void (*Function)(Context&, Arguments...)>
struct PlayCommand<Id, Class, Function> {
    static void play(Context& context, RecordReader& record) {
        std::optional<RecordedUnpack> unpack;
        if constexpr (ImageOf<Id>::Known) {
            unpack.emplace(context, record.read<PixelStore>());
        } else if constexpr (may_read_unpack_buffer(Id)) {
            unpack.emplace(context, PixelStore{});
        }
        // Braces: the arguments are read from the left to the right.
        const std::tuple<Arguments...> arguments{record.read<Arguments>()...};
        const auto call = [&](Arguments... values) {
            execute<Class, Function>(context, values...);
        };
        std::apply(call, arguments);
    }
};

void play_set_attribute(Context& context, RecordReader& record) {
    const auto attribute = record.read<Attribute>();
    const unsigned components = record.read<std::uint8_t>();
    context.immediate().set(attribute, components, record.read<Vec4>());
}

void play_vertex(Context& context, RecordReader& record) {
    const unsigned components = record.read<std::uint8_t>();
    context.immediate().vertex(components, record.read<Vec4>());
}

void play_set_color_index(Context& context, RecordReader& record) {
    context.immediate().set_color_index(record.read<float>());
}

void play_block(Context& context, RecordReader& record) {
    execute_block(context, *reinterpret_cast<VertexBlock*>(record.read<std::uintptr_t>()));
}

constexpr bool is_recorded(Command id, CommandClass command_class) {
    if (command_class == CommandClass::Vertex) {
        return id == Command::Begin || id == Command::End || id == Command::PrimitiveRestartNV;
    }
    return command_class != CommandClass::Immediate && !is_array_draw(id);
}

template <Command Id, CommandClass Class, auto Function>
constexpr Play player_of() {
    if constexpr (is_recorded(Id, Class)) {
        return &PlayCommand<Id, Class, Function>::play;
    } else {
        return nullptr;
    }
}

constexpr std::array<Play, static_cast<std::size_t>(Operation::Count)> Players{
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    player_of<Command::name, CommandClass::command_class, &api::name>(),
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    &play_set_attribute,
    &play_set_color_index,
    &play_vertex,
    &play_block,
};

void play_records(Context& context, std::span<const std::byte> code) {
    const std::byte* at = code.data();
    const std::byte* const end = at + code.size();
    while (at != end) {
        RecordHeader header;
        std::memcpy(&header, at, sizeof(header));
        RecordReader record(at);
        Players[static_cast<std::size_t>(header.operation)](context, record);
        at += header.bytes;
    }
}

class NestingLevel {
public:
    explicit NestingLevel(unsigned& depth)
        : depth_(depth) {
        ++depth_;
    }
    ~NestingLevel() { --depth_; }
    NestingLevel(const NestingLevel&) = delete;
    NestingLevel& operator=(const NestingLevel&) = delete;

private:
    unsigned& depth_;
};

} // namespace

void call_list(Context& context, GLuint name) {
    unsigned& nesting = context.lists().nesting;
    if (nesting >= MaxListNesting) return;
    const std::shared_ptr<DisplayList> list = context.shared().lists.share(name);
    if (!list) return;
    const NestingLevel level(nesting);
    play_records(context, list->code);
}

} // namespace ffgpu::gl
