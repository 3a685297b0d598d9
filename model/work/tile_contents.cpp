#include "model/work/tile_contents.h"

namespace ffgpu::work {

TileContents::TileContents(const TileTarget& target, const Rectangle& bin, bool detects_overwrite)
    : all_(whole_pixel(target.surface.format).covered)
    , stores_all_(!target.depth)
    , samples_(target.surface.samples)
    , pixels_(target.cut(bin))
    , detects_overwrite_(detects_overwrite)
    , missing_(pixels_.empty() ? 0
                               : static_cast<std::size_t>(pixels_.width()) *
                                     static_cast<std::size_t>(pixels_.height()) * samples_) {}

void TileContents::clear(const Rectangle& rectangle, PixelBytes bytes) {
    const Rectangle part = intersect(rectangle, pixels_);
    if (part.empty() || bytes.touched == 0) return;
    dirty_ |= stores_all_ ? all_ : bytes.touched;
    if (!is_valid(bytes.touched & ~bytes.covered)) load_ = true; // Bits of a byte stay.
    if (part == pixels_) {
        cleared_ |= bytes.covered;
        return;
    }
    if (bytes.covered != all_) {
        if (!is_valid(bytes.touched)) load_ = true;
        return;
    }
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x)
            for (unsigned sample = 0; sample < samples_; ++sample)
                write_sample(x, y, sample);
}

void TileContents::test(std::uint32_t read, std::uint32_t written) {
    if (!is_valid(read & all_) && missing_ > 0) load_ = true;
    dirty_ |= written & all_;
}

void TileContents::write(const PreparedQuad& quad, bool reads) {
    for (unsigned lane = 0; lane < 4; ++lane) {
        if ((quad.after_depth >> lane & 1) == 0) continue;
        const int x = static_cast<int>(quad.x + (lane & 1u));
        const int y = static_cast<int>(quad.y + (lane >> 1));
        if (x >= pixels_.x1 || y >= pixels_.y1) continue;
        for (unsigned sample = 0; sample < samples_; ++sample) {
            if (samples_ > 1 && (quad.samples_written >> (4 * lane + sample) & 1) == 0) continue;
            const std::size_t before = missing_;
            dirty_ |= all_;
            write_sample(x, y, sample);
            const bool was_written = missing_ == before;
            if (reads && !was_written && !is_valid(all_)) load_ = true;
        }
    }
}

void TileContents::write_sample(int x, int y, unsigned sample) {
    if (load_ || is_valid(all_)) return; // Nobody will ask.
    const auto width = static_cast<std::size_t>(pixels_.width());
    if (written_.empty()) written_.resize(missing_);
    const std::size_t at = (static_cast<std::size_t>(y - pixels_.y0) * width +
                            static_cast<std::size_t>(x - pixels_.x0)) *
                               samples_ +
                           sample;
    if (written_[at]) return;
    written_[at] = true;
    --missing_;
}

bool TileContents::needs_load() const {
    if (load_) return true;
    if (is_valid(dirty_)) return false;
    return missing_ > 0 || !detects_overwrite_;
}

} // namespace ffgpu::work
