// The Verilated fragment pipe: set-up records in, pixels in memory. It lives in ffgpu_pipe.so,
// which is there where Verilator was when ffgpu was built.
//
// Its memory is the caller's, behind ports with a latency and random stalls. Nothing of a fragment
// is computed here: records, registers and bytes are handed over as they are.

#pragma once

#include "model/gpu/draw_context.h"
#include "rtl/bundles/wave_cycles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ffgpu::rtl {

struct PipeOptions {
    unsigned latency = 20;      // cycles from a read to its answer, at least
    unsigned stall_percent = 0; // of cycles in which a port of memory does not take or give
    bool jitters = true;        // The memory takes a cycle more at random, and gives texels in any
                                // order.
    std::uint64_t seed = 1;
    // Cycles in which nothing moves at any port, after which the pipe is said to stand. A large
    // primitive without a live fragment may take millions.
    std::uint64_t quiet_cycles = 1 << 24;
    // Waves of the pipe go to FOLDER/fragment_pipe.fst; empty: none.
    std::string waves{};
    WaveCycles wave_cycles{};
    // Of this store of colours, counted from 0, each byte's lowest bit is wrong: how tests see that
    // it is told.
    std::optional<std::uint64_t> faulty_store{};
};

// The parts of the pipe that tell what they are at, as the units of the machine in time do.
enum class PipeUnit : std::uint8_t { Raster, Interpolator, Texture, Fragment, Depth, Color, Count };
inline constexpr std::size_t PipeUnits = static_cast<std::size_t>(PipeUnit::Count);
inline constexpr std::array<std::string_view, PipeUnits> PipeUnitNames{
    "raster", "interpolator", "texture", "fragment", "depth", "color"};

// Cycles.
struct PipeActivity {
    std::array<std::uint64_t, PipeUnits> busy{}, stalled{};
};

class Pipe {
public:
    virtual ~Pipe() = default;

    // Texels and targets. Device addresses count from its first byte.
    virtual void set_memory(std::span<std::byte> memory) = 0;
    // What the texel cache holds may have changed. Finishes first.
    virtual void forget_textures() = 0;

    // The draw that records belong to from now on; a former one may still be inside.
    virtual void begin_draw(const DrawContext& context, std::uint32_t number) = 0;
    virtual void add(const SetupRecord& record) = 0;
    // All quads have left. False: they do not move any more.
    virtual bool finish() = 0;
    // The pipe's reset, at once: what is inside is lost, and no draw is begun.
    virtual void reset() = 0;

    virtual std::uint64_t cycles() const = 0;
    virtual PipeActivity activity() const = 0; // in all of them
    virtual double seconds() const = 0;        // of the host's, in which they were clocked
};

// Null: `why` says so.
using OpenPipe = Pipe* (*)(const PipeOptions& options, std::string& why);
constexpr const char* OpenPipeName = "ffgpu_open_rtl_pipe";

} // namespace ffgpu::rtl
