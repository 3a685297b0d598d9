// TexelScan: the texel look-ups of an immediate machine that rasterizes quads, straight from what
// was recorded: those that LookupWalk tells, but for the numbers of places, without whole commands
// and scenes. Quads keep no more than their lines and their place in the raster order.
//
// It reads the functional GPU's work, or whole commands.

#pragma once

#include "model/work/address_map.h"
#include "model/work/batch_reads.h"
#include "model/work/depth_test_masks.h"
#include "model/work/draw_splitter.h"
#include "model/work/drawn_texels.h"
#include "model/work/lookups.h"
#include "model/work/quad_lines.h"
#include "model/work/traversal_keys.h"
#include "model/work/whole_command.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

class TexelScan final : public DrawSink, public CommandSink {
public:
    // What it does not read: tiles, fragment by fragment.
    static bool reads(const WorkConfig& config) {
        return config.raster.architecture == Architecture::Immediate &&
               config.raster.granularity == Granularity::Quad;
    }

    TexelScan(const WorkConfig& config, LookupSink& out);

    void draw_part(const WorkDraw& draw, const DrawPart& part) override;
    void command(std::shared_ptr<const WholeCommand> command) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override;
    void host_transfer(const HostTransfer& transfer) override;
    void end_frame(std::uint32_t frame) override;

private:
    struct Quad {
        std::uint64_t piece = 0;          // and above it the primitive
        std::uint32_t key = 0;            // of the traversal
        std::uint32_t begin = 0, end = 0; // of its lines: those of the quad before, or behind them
        std::uint32_t reads = 0;
    };
    // Quads behind each other, of one piece and by rising keys.
    struct Run {
        std::uint64_t piece = 0;
        std::uint32_t key = 0;            // of the first
        std::uint32_t begin = 0, end = 0; // of quads_

        // Those of one piece and key stay in the order in which they came.
        static bool before(const Run& a, const Run& b);
    };
    struct Places; // draw_places.h

    bool begin(const WorkDraw& draw);
    void place_others(const WorkDraw& draw);
    void add(const WorkBatch& batch);
    void add_each_read(const WorkBatch& batch);
    FragmentMask lanes_of(const WorkBatch& batch) const;
    void add(const TexelAccess& access, unsigned lanes, const TextureLines& texture) {
        if (lanes >> access.lane & 1) lines_of_quad_.add(texture, access);
    }
    void end_quad(const WorkQuad& quad);
    void add(const WorkQuad& quad, std::uint32_t first_line, std::uint32_t reads);
    void add_to_runs(std::uint32_t quad);
    void number_image_pieces();
    void order_runs();
    void sort_runs();
    bool runs_overlap() const;
    void take_apart_overlapping_runs();
    void tell();
    void tell(const Quad& quad);

    const WorkConfig config_;
    LookupSink& out_;
    const TraversalKeys keys_;
    AddressMap addresses_;
    DrawnTexels drawn_texels_{addresses_};
    std::array<const TextureLines*, TextureUnits> textures_{};
    QuadLines lines_of_quad_;
    BatchReads reads_;
    DepthTestPlace test_;
    LookupPlace place_; // of the next
    // Of the draw.
    bool begun_ = false; // Parts of it are there, but not the last.
    std::vector<Quad> quads_;
    std::vector<LineLookup> lines_;
    std::vector<Run> runs_, spare_runs_;
    bool first_ = true;       // no quad of it was told
    std::uint64_t piece_ = 0; // of the quad that was told last
    std::uint32_t block_ = 0, first_line_ = 0;
};

} // namespace ffgpu::work
