// MaterialLog: the materials of a run's vertices, where glMaterial comes between glBegin and glEnd.
// GL gives each vertex the material of the time of its glVertex (GL 1.5, 2.14).

#pragma once

#include "driver/state/lighting_state.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::gl {

using Materials = std::array<MaterialFace, 2>; // front, back

// The vertices from `vertex` on, up to the next change, have these materials.
struct MaterialChange {
    std::uint32_t vertex = 0;
    Materials materials;
};

class MaterialLog {
public:
    bool empty() const { return changes_.empty(); } // All vertices have the materials of the state.
    void clear() { changes_.clear(); }

    // The vertices from `vertex` on have `after`; those before, if nothing else is known, `before`.
    void change(std::uint32_t vertex, const Materials& before, const Materials& after);

    // A new last vertex, `vertex`, has the materials of `original`; those behind it have what the
    // vertices before it had last.
    void repeat(std::uint32_t original, std::uint32_t vertex);

    // The vertices from `count` on are gone: the next one will have the latest materials.
    void keep_vertices(std::uint32_t count);

    // Becomes the log of the vertices `kept`, in their order, and of those that follow them.
    void select(std::span<const std::uint32_t> kept);

    // In the order of their vertices; the first one's is 0. Or none.
    std::span<const MaterialChange> changes() const { return changes_; }

private:
    std::vector<MaterialChange> changes_;
};

} // namespace ffgpu::gl
