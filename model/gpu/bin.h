// Bin: work put off until it can be done tile by tile. It holds the commands that touch pixels, the
// set-up records of their primitives in one arena, and for each tile what to do there, in order.
//
// Its memory is bounded: when it is full(), it must be carried out before more is added.
//
// Tiles cost their lists and the primitives that lie in several of them: large targets are cut into
// large ones.

#pragma once

#include "model/gpu/cleared_tiles.h"
#include "model/gpu/draw_context.h"
#include "model/packets/work_stream.h"
#include "model/raster/coverage.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ffgpu {

struct BinCommand {
    WorkKind kind = WorkKind::Draw;
    std::uint32_t number = 0; // PrimitiveKey::draw
    std::uint32_t frame = 0;
    std::shared_ptr<const PixelContext> pixels{};
    std::shared_ptr<const DrawContext> context{};    // null: a draw that nobody listens to
    ClearCommand clear{};                            // Clear
    std::unique_ptr<const DrawImageCommand> image{}; // Image
    GeometryWork geometry{};                         // Draw, with a work sink
    std::uint32_t register_writes = 0, register_words = 0;
};

class Bin {
public:
    // One step of a tile: a command that covers it as a whole, or a primitive of a draw.
    struct Step {
        std::uint32_t command;
        const SetupRecord* record; // null: the whole command
    };

    // `tile_size`: pixels, a multiple of 8 from 16 to 128; 0: by the targets.
    // `arena_bytes`: for set-up records; one more fits always.
    Bin(int tile_size, std::size_t arena_bytes);

    // Begins anew, for targets of at most `width` by `height` pixels.
    void reset(int width, int height);

    // What of the targets' tiles is clear, for who carries the bin out.
    void set_cleared(ClearedOfTargets cleared) { cleared_ = std::move(cleared); }
    const ClearedOfTargets& cleared() const { return cleared_; }

    int tile_size() const { return tile_size_; }
    std::size_t tile_count() const {
        return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    }

    bool empty() const { return commands_.empty(); }
    bool full() const;

    // The command that primitives are added to from now on. Returns its index.
    std::size_t add_command(BinCommand command);

    // Room for one more record; insert() keeps it.
    SetupRecord& next_record() { return *reinterpret_cast<SetupRecord*>(arena() + used_); }
    void insert();

    // The last record may cover so many pixels, of which others will be told: some 80 bytes a quad,
    // which wait for them. A bin is full when there are many.
    void add_told_pixels(std::uint64_t pixels) { told_pixels_ += pixels; }

    // Adds the current command to all tiles that `area` touches.
    void insert_whole(const Rectangle& area);

    std::vector<BinCommand>& commands() { return commands_; }
    const std::vector<BinCommand>& commands() const { return commands_; }

    // Tiles with work, in any order.
    const std::vector<std::uint32_t>& busy_tiles() const { return busy_; }
    Rectangle tile_rectangle(std::uint32_t tile) const;

    template <class Visit>
    void for_each_step(std::uint32_t tile, Visit&& visit) const;

private:
    // A tile's list is words: a command's index with CommandBit, or a record's place in the arena
    // in units of RecordAlign. A command without WholeBit only says whose the records after it are.
    static constexpr std::uint32_t CommandBit = 1u << 31, WholeBit = 1u << 30;
    static constexpr std::size_t RecordAlign = 16;
    static constexpr std::size_t MaxWords = std::size_t{1} << 18;
    // Places are below 2^12, so that what rounding up adds stays below a tile's share.
    static constexpr unsigned TileShift = 19;
    static_assert(MaxSurfaceSize <= 1u << 12);
    static constexpr std::size_t MaxCommands = 1 << 10; // Each may hold registers.
    static constexpr std::uint64_t MaxToldPixels = 1 << 18;

    struct Tile {
        std::vector<std::uint32_t> words;
        std::uint32_t command = ~0u; // of the last words
    };

    std::byte* arena() const { return arena_[0].bytes; }
    // Of a pixel in a row or column.
    int tile_of(int at) const {
        return static_cast<int>(static_cast<unsigned>(at) * per_tile_size_ >> TileShift);
    }
    Rectangle tiles_under(const Rectangle& area) const;
    void add_word(std::uint32_t tile, std::uint32_t word);

    int asked_tile_size_;
    int tile_size_ = 0;
    unsigned per_tile_size_ = 0; // 2^TileShift / tile_size, rounded up: its product is exact
    std::size_t arena_bytes_;
    int columns_ = 0, rows_ = 0;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> busy_;
    std::vector<BinCommand> commands_;
    ClearedOfTargets cleared_;
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    std::unique_ptr<Line[]> arena_; // Left uninitialised: the host backs it as it is used.
    std::size_t used_ = 0;
    std::size_t word_count_ = 0;
    std::uint64_t told_pixels_ = 0;
};

template <class Visit>
void Bin::for_each_step(std::uint32_t tile, Visit&& visit) const {
    std::uint32_t command = 0;
    for (const std::uint32_t word : tiles_[tile].words) {
        if (!(word & CommandBit)) {
            const std::byte* const at = arena() + std::size_t{word} * RecordAlign;
            visit(Step{command, reinterpret_cast<const SetupRecord*>(at)});
            continue;
        }
        command = word & ~(CommandBit | WholeBit);
        if (word & WholeBit) visit(Step{command, nullptr});
    }
}

} // namespace ffgpu
