// LookupWalk: tells the look-ups of what a machine carries out (MachineOrder), of the lines that
// its configuration names. They are those of the machine in time, which asks in this order where
// its draws test depth at one place; a machine that tests a quad twice asks twice in a row here.
// Depth and colour of a tile-based machine lie on chip: it asks for texels and vertices alone.

#pragma once

#include "model/work/lookups.h"
#include "model/work/machine_order.h"

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace ffgpu::work {

// What the vertex fetch asks its cache for.
struct VertexFetchShape {
    std::uint32_t line_bytes = 64;
    std::uint32_t reuse_entries = 16; // vertices that are not asked for again within a draw
    bool reuse_lru = false;           // the one not used for longest goes; else the first that came
};

class LookupWalk final : public MachineSink {
public:
    LookupWalk(const WorkConfig& config, const VertexFetchShape& vertex, LookupSink& out);

    void scene(PreparedScene&& scene) override;
    void transfer(PreparedTransfer&& transfer) override;
    void host_transfer(const HostTransfer& transfer) override;
    void texels_rewritten(std::vector<std::uint64_t>&& lines) override;
    void end_frame(std::uint32_t frame) override;

private:
    void vertices(const PreparedDraw& draw);
    bool reuse(std::uint32_t vertex);
    void quad(const PreparedScene& scene, const PreparedQuad& quad);
    void step_into(const PreparedQuad& quad);
    void texels(const PreparedScene& scene, const PreparedQuad& quad);
    void depths(const PreparedScene& scene, const PreparedQuad& quad);
    void colors(const PreparedScene& scene, const PreparedQuad& quad);
    void tell(LookupClient client, const LookupPlace& place, std::uint32_t reads);
    void flush_targets();
    bool is_tile_based() const { return config_.raster.architecture == Architecture::TileBased; }

    const WorkConfig config_;
    const VertexFetchShape vertex_;
    const LineGrain depth_grain_, color_grain_;
    LookupSink& out_;
    LookupPlace quad_place_, vertex_place_;      // of the next
    std::uint32_t draw_ = ~0u, primitive_ = ~0u; // of the quad before, in its scene
    std::deque<std::uint32_t> recent_;           // vertices of the draw
    std::vector<LineLookup> lines_;              // of one quad or vertex
};

} // namespace ffgpu::work
