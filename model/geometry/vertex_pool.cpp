#include "model/geometry/vertex_pool.h"

#include "model/base/check.h"

#include <algorithm>
#include <cstring>

namespace ffgpu {
namespace {

// Stages write whole batches.
constexpr std::size_t Records = VertexPool::Capacity + BatchVertices;

} // namespace

void copy_vertex(const WindowVertex& from, WindowVertex& to, unsigned interpolants) {
    std::memcpy(&to, &from, offsetof(WindowVertex, attributes) + interpolants * sizeof(float));
}

VertexPool::VertexPool(ShadeVertices form)
    : shade_(form)
    , window_(std::make_unique<WindowVertex[]>(Records))
    , clip_(Records)
    , eye_(Records)
    , codes_(Records)
    , edge_flags_(Records, 1) {}

void VertexPool::shade(VertexBatch& batch, std::uint32_t slot) {
    check(slot + batch.count <= Capacity, "a chunk has more vertices than the pool");
    WindowVertex* window = &window_[slot];
    shade_(*setup_,
           batch,
           {.window = window, .clip = &clip_[slot], .eye = &eye_[slot], .codes = &codes_[slot]});
    if (setup_->needs.point_size) {
        for (unsigned lane = 0; lane < batch.count; ++lane)
            window[lane].point_size = batch.point_size.lanes[lane];
    }
    if (setup_->needs.edge_flag) {
        const Plane& flags = batch.in[static_cast<unsigned>(Attribute::EdgeFlag)][0];
        for (unsigned lane = 0; lane < batch.count; ++lane)
            edge_flags_[slot + lane] = flags.lanes[lane] != 0;
    }
    if (setup_->needs_two_sides) keep_back_colors(batch, slot);
}

void VertexPool::keep_back_colors(const VertexBatch& batch, std::uint32_t slot) {
    if (!back_) {
        back_ = std::make_unique<WindowVertex[]>(Records);
        back_colors_.resize(Records);
        back_made_.resize(Records);
    }
    for (unsigned lane = 0; lane < batch.count; ++lane) {
        SideColors& colors = back_colors_[slot + lane];
        for (unsigned c = 0; c < 4; ++c)
            colors.color[c] = batch.color[1][c].lanes[lane];
        for (unsigned c = 0; c < 3; ++c)
            colors.secondary[c] = batch.secondary[1][c].lanes[lane];
        back_made_[slot + lane] = 0;
    }
}

const WindowVertex& VertexPool::back(std::uint32_t slot) {
    WindowVertex& vertex = back_[slot];
    if (back_made_[slot]) return vertex;
    const InterpolantLayout& layout = setup_->layout;
    const SideColors& colors = back_colors_[slot];
    copy_vertex(window_[slot], vertex, layout.count);
    if (layout.color >= 0)
        std::copy_n(
            colors.color.begin(), 4, &vertex.attributes[static_cast<unsigned>(layout.color)]);
    if (layout.secondary >= 0)
        std::copy_n(colors.secondary.begin(),
                    3,
                    &vertex.attributes[static_cast<unsigned>(layout.secondary)]);
    back_made_[slot] = 1;
    return vertex;
}

} // namespace ffgpu
