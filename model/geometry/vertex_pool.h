// VertexPool: the shaded vertices of the chunk of a draw that is being assembled.

#pragma once

#include "model/geometry/vertex_batch.h"
#include "model/geometry/vertex_setup.h"
#include "model/geometry/vertex_stages.h"
#include "model/packets/window_vertex.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu {

// Copies what a draw's vertex has in use; `interpolants` is the layout's count.
void copy_vertex(const WindowVertex& from, WindowVertex& to, unsigned interpolants);

struct SideColors {
    Vec4 color;
    Vec3 secondary;
};

class VertexPool {
public:
    // Vertices that primitives of one chunk can refer to.
    static constexpr std::uint32_t Capacity = 4096;

    explicit VertexPool(ShadeVertices form);

    void start(const VertexSetup& setup) { setup_ = &setup; }

    // Shades the batch's vertices into the records from `slot` on.
    void shade(VertexBatch& batch, std::uint32_t slot);

    ClipCode code(std::uint32_t slot) const { return codes_[slot]; }
    bool edge_flag(std::uint32_t slot) const { return edge_flags_[slot] != 0; }
    const Vec4& clip(std::uint32_t slot) const { return clip_[slot]; }
    const Vec4& eye(std::uint32_t slot) const { return eye_[slot]; }
    const WindowVertex& front(std::uint32_t slot) const { return window_[slot]; }
    // The vertex with its back colours, where the draw has them.
    const WindowVertex& side(std::uint32_t slot, bool front_facing) {
        if (front_facing || !setup_->needs_two_sides) return window_[slot];
        return back(slot);
    }

private:
    const WindowVertex& back(std::uint32_t slot);
    void keep_back_colors(const VertexBatch& batch, std::uint32_t slot);

    const ShadeVertices shade_;
    const VertexSetup* setup_ = nullptr;
    std::unique_ptr<WindowVertex[]> window_;
    std::vector<Vec4> clip_, eye_;
    std::vector<ClipCode> codes_;
    std::vector<std::uint8_t> edge_flags_;

    std::unique_ptr<WindowVertex[]> back_; // Made when one is asked for.
    std::vector<SideColors> back_colors_;
    std::vector<std::uint8_t> back_made_;
};

} // namespace ffgpu
