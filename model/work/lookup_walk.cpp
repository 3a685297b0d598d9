#include "model/work/lookup_walk.h"

#include "model/base/powers_of_two.h"
#include "model/work/surface_lines.h"

#include <algorithm>
#include <bit>

namespace ffgpu::work {
namespace {

// Four bits: a digit of the constant for each mask, as a machine without such an instruction
// counts.
std::uint32_t lanes(std::uint8_t mask) {
    return static_cast<std::uint32_t>(0x4332'3221'3221'2110u >> 4 * (mask & 15u) & 15u);
}

} // namespace

LookupWalk::LookupWalk(const WorkConfig& config, const VertexFetchShape& vertex, LookupSink& out)
    : config_(config)
    , vertex_(vertex)
    , depth_grain_(config.depth_cache.line_bytes)
    , color_grain_(config.color_cache.line_bytes)
    , out_(out) {}

void LookupWalk::tell(LookupClient client, const LookupPlace& place, std::uint32_t reads) {
    if (!lines_.empty()) out_.lookups(client, place, lines_, reads);
    lines_.clear();
}

void LookupWalk::scene(PreparedScene&& scene) {
    for (const PreparedDraw& draw : scene.draws)
        vertices(draw);
    draw_ = primitive_ = ~0u;
    for (const PreparedQuad& each : scene.quads)
        quad(scene, each);
}

// --- Vertices ------------------------------------------------------------------------------------

bool LookupWalk::reuse(std::uint32_t vertex) {
    const auto found = std::find(recent_.begin(), recent_.end(), vertex);
    const bool is_there = found != recent_.end();
    if (is_there && !vertex_.reuse_lru) return true;
    if (is_there) recent_.erase(found);
    if (vertex_.reuse_entries == 0) return false;
    if (recent_.size() == vertex_.reuse_entries) recent_.pop_front();
    recent_.push_back(vertex);
    return is_there;
}

void LookupWalk::vertices(const PreparedDraw& draw) {
    const GeometryWork& work = draw.geometry;
    recent_.clear();
    vertex_place_.begin(Reuse::Draw);
    for (const std::uint32_t vertex : work.vertices) {
        vertex_place_.begin(Reuse::Primitive);
        if (reuse(vertex)) continue;
        const std::uint64_t at = work.vertex_address + std::uint64_t{vertex} * work.vertex_bytes;
        const std::uint64_t last = at + std::max(work.vertex_bytes, 1u) - 1;
        for (std::uint64_t line = quotient(at, vertex_.line_bytes);
             line <= quotient(last, vertex_.line_bytes);
             ++line)
            lines_.push_back({line, false});
        tell(LookupClient::Vertex, vertex_place_, 1);
        ++vertex_place_.number;
    }
}

// --- Quads ---------------------------------------------------------------------------------------

void LookupWalk::step_into(const PreparedQuad& quad) {
    quad_place_.x = quad.x;
    quad_place_.y = quad.y;
    const bool new_draw = quad.draw != draw_;
    quad_place_.begin(new_draw                       ? Reuse::Draw
                      : quad.primitive != primitive_ ? Reuse::Primitive
                      : quad.new_tile                ? Reuse::Tile
                                                     : Reuse::Quad);
    draw_ = quad.draw;
    primitive_ = quad.primitive;
}

void LookupWalk::quad(const PreparedScene& scene, const PreparedQuad& quad) {
    step_into(quad);
    const bool on_chip = is_tile_based();
    if (!on_chip) depths(scene, quad);
    if (quad.after_early_depth != 0) texels(scene, quad);
    if (!on_chip) colors(scene, quad);
    ++quad_place_.number;
}

void LookupWalk::texels(const PreparedScene& scene, const PreparedQuad& quad) {
    for (const std::uint64_t line : scene.lines_of(quad))
        lines_.push_back({line, false});
    tell(LookupClient::Texel, quad_place_, quad.texel_reads);
}

void LookupWalk::depths(const PreparedScene& scene, const PreparedQuad& quad) {
    const PreparedDraw& draw = scene.draws[quad.draw];
    if (!draw.uses_depth()) return;
    const auto lines = scene.depth_lines(quad);
    const std::uint32_t samples = lanes(quad.covered);
    if (draw.tests_twice) {
        for (const std::uint64_t line : lines)
            lines_.push_back({line, false});
        tell(LookupClient::Depth, quad_place_, samples);
        if (quad.after_early_depth == 0) return;
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool writes = scene.depth_bytes(quad, i).touched != 0;
        if (draw.reads_depth() || writes) lines_.push_back({lines[i], writes});
    }
    tell(LookupClient::Depth, quad_place_, samples);
}

void LookupWalk::colors(const PreparedScene& scene, const PreparedQuad& quad) {
    const PreparedDraw& draw = scene.draws[quad.draw];
    if (!draw.writes_color) return;
    const auto lines = scene.color_lines(quad);
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines_.push_back({lines[i], scene.color_bytes(quad, i).touched != 0});
    tell(LookupClient::Color, quad_place_, lanes(quad.after_depth));
}

// --- What comes between --------------------------------------------------------------------------

void LookupWalk::flush_targets() {
    out_.flush(LookupClient::Depth);
    out_.flush(LookupClient::Color);
}

void LookupWalk::transfer(PreparedTransfer&& transfer) {
    if (transfer.writes_back_caches) flush_targets();
    for (const LookupClient client : {LookupClient::Depth, LookupClient::Color}) {
        const bool depth = client == LookupClient::Depth;
        const LineMask all = (depth ? depth_grain_ : color_grain_).all();
        std::vector<OverwrittenLine> lines;
        for (const TransferLine& part : transfer.lines)
            if (part.write && part.depth == depth)
                lines.push_back({part.line.number, part.line.bytes.covered == all});
        if (!lines.empty()) out_.overwritten(client, lines);
    }
}

// The driver reads what the caches have written back. What it writes goes past them; vertices are
// looked up where the driver wrote them; of texels texels_rewritten() tells.
void LookupWalk::host_transfer(const HostTransfer& transfer) {
    if (!transfer.is_write) return flush_targets();
    if (transfer.bytes == 0) return;
    std::vector<OverwrittenLine> lines;
    const std::uint64_t last = quotient(transfer.at + transfer.bytes - 1, vertex_.line_bytes);
    for (std::uint64_t line = quotient(transfer.at, vertex_.line_bytes); line <= last; ++line)
        lines.push_back({line, false});
    out_.overwritten(LookupClient::Vertex, lines);
}

void LookupWalk::texels_rewritten(std::vector<std::uint64_t>&& lines) {
    tell_rewritten(lines, out_);
}

void LookupWalk::end_frame(std::uint32_t frame) {
    flush_targets();
    out_.end_frame(frame);
    quad_place_.begin(Reuse::Frame);
    vertex_place_.begin(Reuse::Frame);
}

} // namespace ffgpu::work
