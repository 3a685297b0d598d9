// The work file: whole commands, uploads and ends of frames, as docs/work_file.md tells. A file is
// a magic number, a version, and blocks of about a MiB, each a zstd frame with a checksum. A block
// holds columns, one a kind of number: what is alike lies together, which is what makes it small.

#pragma once

#include "model/work/whole_command.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ffgpu::work {

inline constexpr std::string_view WorkFileMagic = "FFGPUWRK";
inline constexpr std::uint32_t WorkFileVersion = 5;

enum class BlockKind : std::uint32_t { Names = 1, Items = 2, End = 3 };

// Before each block's bytes.
struct BlockHeader {
    std::uint32_t kind = 0;
    std::uint32_t items = 0;
    std::uint32_t raw_bytes = 0;
    std::uint32_t packed_bytes = 0;
};

inline constexpr std::size_t BlockBytes = std::size_t{1} << 20;    // A block ends beyond these;
inline constexpr std::size_t MaxBlockBytes = std::size_t{8} << 20; // an item is far smaller.

// What an item of a block is; the first byte of it in Column::Control.
enum class Item : std::uint8_t {
    Command,
    Vertex,
    Primitive,
    Quad,
    HostTransfer,
    FrameEnd,
    FrameFigures,
    SurfaceContent,
    Row, // of a surface's content
    Count
};

enum class Column : std::uint8_t {
    Control,   // items but quads, and their numbers
    Vertex,    // vertex numbers, as steps
    Assembly,  // of primitives: places of the last vertices, as steps
    Outcome,   // what became of them
    PieceX,    // boxes of pieces: left, as a step, and width
    PieceY,    // below, as a step, and height
    PieceWork, // what set-up made of them: blocks, planes, values, divisors, perspective
    Primitive, // of quads
    Piece,
    Row,
    Column,
    Covered,
    Fate,
    Samples,
    AccessCount,
    Shape, // lane, filter, and whether all but x and y is as foreseen
    X,
    Y,
    Rare, // what is not as foreseen
    Values,
    Count
};
inline constexpr std::size_t ColumnCount = static_cast<std::size_t>(Column::Count);

// Bits of Column::Shape: lane in 0 and 1, TexelAccess::linear in 2 to 4.
inline constexpr std::uint8_t ShapeForeseen = 1 << 5;

// Bits of Column::Outcome: the fate in 0 and 1; whether the key is the one after that before;
// whether a number of planes follows; and whether the number of pieces does, else it is 1 where
// drawn.
inline constexpr std::uint8_t OutcomeNextKey = 1 << 2, OutcomeClipped = 1 << 3,
                              OutcomePieces = 1 << 4;

// What the next access is foreseen to be, from those before it: the same in writer and reader. The
// first lane of a quad steps on as it did from the quad before; the other lanes lie about it as
// they did in the quad before.
class AccessForecast {
public:
    struct Expected {
        std::uint16_t x = 0, y = 0;
        std::uint8_t level = 0;
        std::uint16_t layer = 0;
    };

    // What a unit's accesses of one number within their lane were in the quad before.
    struct Past {
        std::uint32_t place = 0; // of the first lane: x, and y above it
        std::uint32_t kind = 0;  // of the first lane: layer, and level above it
        // Of the first lane, and of lanes 1 to 3: x, and y above it, each modulo 2^16.
        alignas(16) std::array<std::uint32_t, 4> steps{};
    };

    // The accesses of a quad in one unit, one after the other.
    class Quad {
    public:
        explicit Quad(Past* first)
            : first_(first)
            , past_(first) {}

        Expected next(unsigned lane) {
            if (lane != lane_) {
                if (lane_ == None) first_lane_ = lane;
                lane_ = lane;
                slot_ = lane == first_lane_ ? 0 : lane;
                past_ = first_;
            } else if (past_ != first_ + (Ordinals - 1)) {
                ++past_;
            }
            const std::uint32_t step = past_->steps[slot_];
            return {static_cast<std::uint16_t>(past_->place + step),
                    static_cast<std::uint16_t>((past_->place >> 16) + (step >> 16)),
                    static_cast<std::uint8_t>(past_->kind >> 16),
                    static_cast<std::uint16_t>(past_->kind)};
        }

        // What it was.
        void take(const Expected& access) {
            past_->steps[slot_] = halves(access.x - past_->place, access.y - (past_->place >> 16));
            if (slot_ != 0) return;
            past_->place = halves(access.x, access.y);
            past_->kind = halves(access.layer, access.level);
        }

    private:
        static constexpr unsigned None = ~0u;

        static constexpr std::uint32_t halves(std::uint32_t low, std::uint32_t high) {
            return (low & 0xffff) | high << 16;
        }

        Past* first_;
        Past* past_; // of the access at hand
        unsigned lane_ = None, first_lane_ = None;
        unsigned slot_ = 0; // among past_->steps
    };
    Quad quad(unsigned unit) { return Quad(past_[unit].data()); }

    // For who looks at all lanes of a quad at once.
    Past& past(unsigned unit, unsigned ordinal) { return past_[unit][ordinal]; }

private:
    static constexpr unsigned Ordinals = 32; // of the accesses of a lane

    std::array<std::array<Past, Ordinals>, TextureUnits> past_{};
};

} // namespace ffgpu::work
