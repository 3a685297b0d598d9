// A program of OpenGL calls, each byte a choice of what to call and with what (random_walk.h).

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/kept_gpu.h"
#include "tests/random_calls/random_walk.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

using namespace ffgpu;

namespace {

constexpr unsigned Width = 80, Height = 56;

// Numbers of 16 bits; 0 behind the last.
class Choices {
public:
    explicit Choices(fuzz::Bytes bytes)
        : left_(bytes) {}

    bool empty() const { return left_.empty(); }
    std::uint32_t next() {
        std::uint16_t value = 0;
        const fuzz::Bytes bytes = left_.first(std::min(sizeof value, left_.size()));
        if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
        left_ = left_.subspan(bytes.size());
        return value;
    }

private:
    fuzz::Bytes left_;
};

} // namespace

void ffgpu::fuzz::run(Bytes bytes) {
    static const gl::Registry registry = gl::read_registry("/usr/share/khronos-api/gl.xml");
    static gl::WalkMemory memory;
    if (registry.empty()) return;
    const KeptGpu<16> kept;
    gl::OffscreenContext context(KeptGpu<16>::gpu(), {.width = Width, .height = Height});
    context.make_current();
    Choices choices(bytes);
    gl::RandomWalk walk(registry, memory, [&choices] { return choices.next(); });
    while (!choices.empty())
        walk.step(context.context());
    walk.settle();
    std::array<std::uint8_t, 4> pixel{};
    gl::entry::ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
}
