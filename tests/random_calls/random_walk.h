// RandomWalk: a program that no programmer would write. It calls any command with arguments of the
// right kind in any order, as far as OpenGL leaves the outcome defined: what is read stays inside
// of the memory that a pointer has, and lists do not call lists.

#pragma once

#include "driver/commands/command.h"
#include "driver/context/context.h"
#include "tests/random_calls/registry.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ffgpu::gl {

// Bytes behind every pointer: more than any argument of the walk makes a command touch.
constexpr std::size_t WalkMemoryBytes = std::size_t{16} << 20;

// What the pointers point to. Of small integers, so that whatever is read as an index or a name
// stays small; of floating-point numbers; and for what commands write.
struct WalkMemory {
    std::vector<std::uint32_t> small_integers, output;
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<const void*> pointers;

    WalkMemory();
};

class RandomWalk {
public:
    // `numbers` gives the walk's choices: any numbers.
    RandomWalk(const Registry& registry, WalkMemory& memory, std::function<std::uint32_t()> numbers)
        : registry_(registry)
        , memory_(memory)
        , numbers_(std::move(numbers)) {}

    // A call of any command, or a primitive of some vertices.
    void step(Context& context);

    // Ends what was begun: primitive, list, framebuffer object.
    void settle();

    // Of each command, by its number: calls that were not refused.
    const std::vector<unsigned>& accepted() const { return accepted_; }

    // The calls as text on stderr, before they are made.
    bool verbose = false;

private:
    struct Call {
        Context& context;
        std::string_view name;
        const std::vector<RegistryParameter>& parameters;
        bool has_pointer;
    };
    template <class... Arguments>
    friend struct Caller;

    unsigned below(unsigned limit) { return numbers_() % limit; }
    bool one_in(unsigned n) { return below(n) == 0; }

    void call(Context& context, unsigned command);
    void primitive(Context& context);
    bool is_left_out(Context& context, unsigned command) const;

    template <class T>
    T argument(const Call& call, std::size_t index);
    GLuint enumerant(const RegistryParameter& parameter);
    std::int64_t integer(const Call& call, const RegistryParameter& parameter);
    double number(const Call& call, const RegistryParameter& parameter);
    double plain_number();
    const void* pointer(const Call& call, const RegistryParameter& parameter, bool is_const);

    const Registry& registry_;
    WalkMemory& memory_;
    std::function<std::uint32_t()> numbers_;
    std::vector<unsigned> accepted_ = std::vector<unsigned>(static_cast<unsigned>(Command::Count));
};

template <class T>
T RandomWalk::argument(const Call& call, std::size_t index) {
    const RegistryParameter& parameter = call.parameters[index];
    if constexpr (std::is_pointer_v<T>) {
        using Target = std::remove_pointer_t<T>;
        return static_cast<T>(const_cast<void*>(pointer(call, parameter, std::is_const_v<Target>)));
    } else if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(number(call, parameter));
    } else if (parameter.type == "GLenum" || parameter.type == "GLbitfield") {
        return static_cast<T>(enumerant(parameter));
    } else {
        return static_cast<T>(integer(call, parameter));
    }
}

} // namespace ffgpu::gl
