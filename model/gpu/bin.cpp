#include "model/gpu/bin.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu {
namespace {

// Those that are small enough for several threads to share a small picture.
int tile_size_for(int width, int height) {
    constexpr int Large = 1 << 19; // pixels
    return width * height > Large ? 128 : 64;
}

} // namespace

Bin::Bin(int tile_size, std::size_t arena_bytes)
    : asked_tile_size_(tile_size)
    , arena_bytes_(std::max(arena_bytes, MaxSetupRecordBytes))
    , arena_(new Line[(arena_bytes_ + sizeof(Line) - 1) / sizeof(Line)]) {
    check(tile_size == 0 ||
              (tile_size >= 16 && tile_size <= MaxTileSize && tile_size % BlockSize == 0),
          "a tile is 16 to 128 pixels, in steps of 8");
}

void Bin::reset(int width, int height) {
    for (const std::uint32_t tile : busy_) {
        tiles_[tile].words.clear();
        tiles_[tile].command = ~0u;
    }
    busy_.clear();
    commands_.clear();
    used_ = 0;
    word_count_ = 0;
    told_pixels_ = 0;
    cleared_ = {};
    tile_size_ = asked_tile_size_ ? asked_tile_size_ : tile_size_for(width, height);
    const auto size = static_cast<unsigned>(tile_size_);
    per_tile_size_ = ((1u << TileShift) + size - 1) / size;
    columns_ = (width + tile_size_ - 1) / tile_size_;
    rows_ = (height + tile_size_ - 1) / tile_size_;
    if (tiles_.size() < tile_count()) tiles_.resize(tile_count());
}

bool Bin::full() const {
    return used_ + MaxSetupRecordBytes > arena_bytes_ || word_count_ >= MaxWords ||
           commands_.size() >= MaxCommands || told_pixels_ >= MaxToldPixels;
}

std::size_t Bin::add_command(BinCommand command) {
    commands_.push_back(std::move(command));
    return commands_.size() - 1;
}

void Bin::add_word(std::uint32_t tile, std::uint32_t word) {
    Tile& list = tiles_[tile];
    if (list.words.empty()) busy_.push_back(tile);
    const auto command = static_cast<std::uint32_t>(commands_.size() - 1);
    if (list.command != command && !(word & CommandBit)) {
        list.words.push_back(command | CommandBit);
        ++word_count_;
    }
    list.command = command;
    list.words.push_back(word);
    ++word_count_;
}

Rectangle Bin::tiles_under(const Rectangle& area) const {
    return intersect(
        {tile_of(area.x0), tile_of(area.y0), tile_of(area.x1 - 1) + 1, tile_of(area.y1 - 1) + 1},
        {0, 0, columns_, rows_});
}

void Bin::insert() {
    const SetupRecord& record = next_record();
    const auto word = static_cast<std::uint32_t>(used_ / RecordAlign);
    used_ += record.bytes();
    const Rectangle& box = record.box;
    const int column = tile_of(box.x0), row = tile_of(box.y0);
    if (column == tile_of(box.x1 - 1) && row == tile_of(box.y1 - 1)) [[likely]]
        return add_word(static_cast<std::uint32_t>(row * columns_ + column), word);
    const Rectangle tiles = tiles_under(box);
    const bool many = tiles.width() > 2 || tiles.height() > 2;
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x) {
            const auto tile = static_cast<std::uint32_t>(y * columns_ + x);
            if (!many || may_touch(record, tile_rectangle(tile))) add_word(tile, word);
        }
}

void Bin::insert_whole(const Rectangle& area) {
    if (area.empty()) return;
    const auto word = static_cast<std::uint32_t>(commands_.size() - 1) | CommandBit | WholeBit;
    const Rectangle tiles = tiles_under(area);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x)
            add_word(static_cast<std::uint32_t>(y * columns_ + x), word);
}

Rectangle Bin::tile_rectangle(std::uint32_t tile) const {
    const int x = static_cast<int>(tile) % columns_ * tile_size_;
    const int y = static_cast<int>(tile) / columns_ * tile_size_;
    return {x, y, x + tile_size_, y + tile_size_};
}

} // namespace ffgpu
