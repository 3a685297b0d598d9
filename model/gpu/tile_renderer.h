// TileRenderer: carries out bins' work in one tile. One for each thread; it holds the batch that
// the stages pass on, and calls them in the order of the pipe.

#pragma once

#include "model/gpu/bin_sequence.h"
#include "model/gpu/hidden_blocks.h"
#include "model/gpu/raster_statistics.h"
#include "model/gpu/stage_tap.h"
#include "model/gpu/stages.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/work_stream.h"
#include "model/raster/interpolator.h"
#include "model/raster/quad_collector.h"

#include <memory>
#include <memory_resource>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu {

class TileRenderer {
public:
    TileRenderer(std::span<std::byte> memory, const Stages& stages)
        : memory_(memory)
        , stages_(stages)
        , hidden_(memory) {}

    // Where what was done is recorded, and in what memory its lists lie.
    struct Recording {
        WorkTile* tile = nullptr; // null: nowhere
        std::pmr::memory_resource* memory = nullptr;
    };
    void render(const BinSequence& sequence, std::uint32_t tile, const Recording& recording);

    // From now on records tell values, too.
    void set_values(bool values) { values_ = values; }

    // From now on `probe` is told what each stage does; null: nobody.
    void set_probe(StageProbe* probe);

    FragmentCounts take_counts() { return std::exchange(counts_, {}); }

private:
    void render(const Bin& bin);
    void begin_command(const BinCommand& command);
    void draw_record(const SetupRecord& record);
    void draw_small(const SetupRecord& record);
    bool passes_over_hidden() const;
    void draw_samples(const SetupRecord& record);
    void draw_smooth(const SetupRecord& record);
    void whole_command(const BinCommand& command);
    void clear(const BinCommand& command, const Rectangle& area);
    void tell_drawn();
    void draw_image(const BinCommand& command);

    void flush();
    // `covered`: before any test.
    void shade_units(std::span<const BatchRun> runs, const FragmentMask& covered);
    void sample_unit(unsigned unit, const FragmentMask& covered);
    bool is_cube(unsigned unit) const { return pixels_->textures[unit].kind == TextureKind::Cube; }
    bool keeps_colors() const;
    bool wants_samples() const;
    void finish_batch(const FragmentMask& covered);
    void finish_kept(std::span<const BatchRun> runs, const FragmentMask& covered);
    void interpolate_kept(std::span<const BatchRun> runs);
    void tell(const FragmentMask& covered, const FragmentMask& after_early_depth);
    void interpolate_depths();
    void begin_samples();
    void count(const FragmentMask& covered, const FragmentMask& after_early_depth);
    void count_samples();
    void count_hidden(BlockMask mask);
    void record(const FragmentMask& covered, const FragmentMask& after_early_depth);
    void record_quads(const FragmentMask& covered,
                      const FragmentMask& early,
                      std::span<WorkQuad> quads) const;
    void record_pieces(WorkBatch& work) const;
    bool records_values() const { return recording_.tile && values_; }
    const ProbeTap* pipe_tap() const { return tap_ ? &tap_->pipe() : nullptr; }
    bool multisampled() const { return pixels_->pipe.samples > 1; }

    std::span<std::byte> memory_;
    const Stages& stages_;
    FragmentCounts counts_;

    // Of the tile in work.
    Rectangle tile_;
    std::uint32_t tile_number_ = 0;
    const ClearedOfTargets* cleared_ = nullptr;
    Rectangle drawn_; // by draws of pixels_, and perhaps beside the tile
    Recording recording_;
    bool values_ = false;
    std::uint32_t command_ = 0;
    const BinCommand* binned_ = nullptr; // its command_
    const PixelContext* pixels_ = nullptr;

    FragmentBatch batch_{};
    FragmentFates fates_;         // of the batch
    SampleMasks covered_samples_; // of the batch, where targets are multisampled
    SampleDepths sample_depths_;
    LaneWords colors_; // of the batch, where nothing changes them
    QuadCollector collector_{batch_, stages_.pack_quads};
    TileCoverage coverage_, windows_;
    HiddenBlocks hidden_;
    TileSampleCoverage sample_coverage_;
    PerspectivePlanes perspective_;
    TexCoordPlanes coordinates_;
    std::vector<TexelFootprints> footprints_;
    std::unique_ptr<StageTap> tap_; // with a probe
};

} // namespace ffgpu
