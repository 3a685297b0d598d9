// PixelHistory: all that happened to one pixel of a picture in a frame, in order. Plain data; who
// fills it is explain_frame(), and writers make text, JSON and pictures of it.

#pragma once

#include "model/packets/draw_state.h"
#include "model/packets/stage_probe.h"
#include "tools/explain/pixel_places.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

using probed::Rgba;

// A primitive as it came to set-up.
struct PrimitiveNote {
    PrimitiveShape shape = PrimitiveShape::Triangle;
    bool front_facing = true;
    std::vector<WindowVertex> vertices; // 1 to 3

    // Of a triangle, at a pixel's centre: each vertex' share by area. Empty: it has none.
    std::vector<double> weights(unsigned x, unsigned y) const;
    // The same with perspective: by w.
    std::vector<double> perspective_weights(unsigned x, unsigned y) const;
};

struct ProbeNote {
    probed::Probe probe;
    std::vector<probed::LevelFilter> levels; // of a wide filter all of its accesses
};

struct TextureNote {
    unsigned unit = 0;
    unsigned carried = 0;
    std::array<double, 4> over_w{};           // in the record's scale; the carried ones
    std::array<float, 3> coordinates{};       // s t r after the division
    std::optional<probed::QuadLevels> quad{}; // none, and no probes: the fragment had ended
    std::vector<ProbeNote> probes{};
    Rgba color{};
};

struct EnvironmentNote {
    unsigned unit = 0;
    Rgba previous{}, result{};
};

struct ColorChange {
    Rgba before{}, after{};
};

// One visit to the depth target.
struct DepthVisit {
    unsigned sample = 0;
    bool early = false, passed_stencil = false, passed_depth = false;
    std::uint32_t depth = 0; // the fragment's
    std::uint32_t stored_depth = 0, new_depth = 0;
    std::uint8_t stored_stencil = 0, new_stencil = 0;
};

struct WriteNote {
    unsigned target = 0, sample = 0;
    Rgba source{};
    std::uint32_t destination = 0, blended = 0, stored = 0;
};

// Where a fragment ended: as the counters have it.
enum class FragmentEnd : std::uint8_t { Written, EarlyDepth, Coverage, Alpha, Stencil, Depth };
constexpr std::array<std::string_view, 6> FragmentEndNames{
    "written", "early depth test", "coverage", "alpha test", "stencil test", "depth test"};

// What the machine in time said; cycles count from the frame's begin.
struct TexelLookup {
    unsigned unit = 0, level = 0, x = 0, y = 0, layer = 0;
    std::uint64_t line = 0; // the line's number
    bool missed = false;
    std::optional<std::uint64_t> cycle{}; // none: the quad asked no cache
};
// Of the depth or the colour cache: a line of the targets that the quad asked for.
struct TargetLookup {
    enum class Cache : std::uint8_t { Depth, Color };
    Cache cache = Cache::Depth;
    std::uint64_t line = 0;
    bool missed = false;
    std::uint64_t cycle = 0;
};
struct TimingNote {
    std::vector<TexelLookup> lookups;
    std::vector<TargetLookup> targets;    // in the order of the cycles
    std::optional<std::uint64_t> retired; // its quad's last cycle
};

struct FragmentNote {
    FragmentKey key; // Its sequence: of sample 0.
    std::uint32_t piece = 0;
    unsigned x = 0, y = 0; // window pixel
    bool image = false;    // of drawn pixels
    bool front_facing = true;
    std::shared_ptr<const DrawState> state; // its draw's
    std::shared_ptr<const PrimitiveNote> primitive{};
    std::vector<std::int64_t> edges{};
    unsigned samples_covered = 1; // bits
    std::optional<std::uint32_t> depth{};
    std::vector<std::uint32_t> sample_depths{};
    std::optional<double> inverse_w{}; // in the record's scale
    float w = 0;
    bool has_colors = false; // interpolated, or an image's
    std::array<double, 4> primary_over_w{}, secondary_over_w{};
    double fog_over_w = 0;
    Rgba primary{}, secondary{};
    float fog_coordinate = 0;
    std::vector<TextureNote> textures{};
    std::vector<EnvironmentNote> environments{};
    std::optional<ColorChange> color_sum{}, fog{}, antialias{};
    unsigned fog_factor = 0, coverage = 0;                // 0 .. 255
    std::optional<std::array<unsigned, 2>> sample_mask{}; // bits before and after
    std::optional<bool> alpha_passed{};
    std::uint8_t alpha = 0; // what was tested
    std::vector<DepthVisit> visits{};
    std::vector<WriteNote> writes{};
    FragmentEnd end = FragmentEnd::Written;
    TimingNote timing{};

    const Registers& registers() const { return state->regs(); }
};

// A pixel's colour, of each sample: rgba8 with red lowest, as it reads.
struct PixelValue {
    unsigned samples = 1;
    std::array<std::uint32_t, MaxSamples> color{};

    bool operator==(const PixelValue&) const = default;
};

struct PixelEvent {
    enum class Kind : std::uint8_t {
        Fragment,
        Scissor, // A primitive would have covered the pixel, but for the scissor,
        Stipple, // or the stipple pattern.
        Clear,
        StencilImage,
        Copy,   // to the pixel
        Upload, // The host wrote its bytes.
    };

    Kind kind = Kind::Fragment;
    std::size_t step = 0;  // of the tape
    std::size_t place = 0; // of the history
    CallName call{};
    std::uint32_t draw = 0, primitive = 0, piece = 0; // Fragment, Scissor, Stipple
    std::shared_ptr<FragmentNote> fragment{};         // Fragment
    ClearCommand clear{};
    bool outside_scissor = false; // Clear, StencilImage: it leaves the pixel alone.
    SurfacePixel source{};        // Copy
    unsigned pictures = 1;        // Copy: the mean of so many, of which `source` is the first
    PixelValue after{};

    // A primitive's: of a fragment, or of none.
    bool is_of_draw() const {
        return kind == Kind::Fragment || kind == Kind::Scissor || kind == Kind::Stipple;
    }
    // Of the first depth target that goes with the place, behind a clear or a stencil image.
    std::optional<std::uint32_t> depth_after{}, stencil_after{};
};
constexpr std::array<std::string_view, 7> EventNames{"fragment",
                                                     "cut by the scissor",
                                                     "taken out by the stipple",
                                                     "clear",
                                                     "stencil image",
                                                     "copy",
                                                     "upload"};

struct PixelHistory {
    std::uint64_t frame = 0;
    unsigned x = 0, y = 0; // of the picture, from the upper left
    std::vector<PixelPlace> places{};
    std::vector<PixelValue> before{}; // of each place, before the frame
    std::vector<PixelEvent> events{};
    std::uint32_t value = 0;  // the picture's pixel, as the frame's own drawing left it
    bool from_trace = false;  // else there are no calls
    std::uint64_t cycles = 0; // that the frame took; 0: it was not timed
};

} // namespace ffgpu::tools
