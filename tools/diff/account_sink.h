// AccountSink: takes what a backend did, entry by entry, exactly enough to tell where two backends
// part. An entry is what one stage made of one fragment, primitive, pixel or write.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ffgpu::tools {

// In the order of the machine: where several differ, the first is nearest to the cause.
enum class AccountStage : std::uint8_t {
    Uploads,   // the host's writes to device memory since the command before
    Registers, // writes of registers since the command before
    Command,   // the command's own fields
    SetUp,
    Coverage,
    Depth,
    Perspective,
    Colors,
    TexCoords,
    Texture,
    Environment,
    ColorSum,
    Fog,
    Antialias,
    SampleMask,
    AlphaTest,
    StencilDepth,
    ColorWrite,
    Target,   // a pixel of a surface behind the command
    Counters, // statistics, as the command changed them
};

constexpr std::array<std::string_view, 20> AccountStageNames{
    "uploads",     "registers",     "command",     "set_up",     "coverage",
    "depth",       "perspective",   "colors",      "tex_coords", "texture",
    "environment", "color_sum",     "fog",         "antialias",  "sample_mask",
    "alpha_test",  "stencil_depth", "color_write", "target",     "counters"};

// A stage, and which of several: the texture unit, the colour target (of Target: DepthUnit is the
// depth target).
struct AccountPart {
    static constexpr unsigned Units = 9, DepthUnit = 8;

    AccountStage stage{};
    unsigned unit = 0;

    constexpr std::size_t index() const { return static_cast<std::size_t>(stage) * Units + unit; }
    static constexpr std::size_t Count = AccountStageNames.size() * Units;
    static constexpr AccountPart from(std::size_t index) {
        return {static_cast<AccountStage>(index / Units), static_cast<unsigned>(index % Units)};
    }
};

// "texture 1", "fog".
std::string part_name(AccountPart part);

// What the entry is about. Fragment: a lane of a quad, of one sample. Primitive: primitive and
// piece alone. Pixel: x, y and sample alone. Numbered: `primitive` counts them.
struct AccountPlace {
    enum class Kind : std::uint8_t { Numbered, Primitive, Fragment, Pixel };

    Kind kind = Kind::Numbered;
    std::uint32_t primitive = 0, piece = 0;
    std::uint32_t x = 0,
                  y = 0; // Fragment: of the quad's lane 0; window pixels, from the lower left
    std::uint8_t lane = 0, sample = 0;
};

std::string place_name(const AccountPlace& place);

class AccountSink {
public:
    virtual ~AccountSink() = default;

    virtual void begin(AccountPart part, const AccountPlace& place) = 0;
    // Fields of the entry; `index` tells several of one name apart, -1: there is one.
    virtual void integer(std::string_view field, std::int64_t value, int index = -1) = 0;
    virtual void real(std::string_view field, double value, int index = -1) = 0;
    virtual void
    color(std::string_view field, std::uint32_t rgba8, int index = -1) = 0; // red lowest
    virtual void text(std::string_view field, std::string_view value) = 0;
    virtual void end() = 0;
};

} // namespace ffgpu::tools
