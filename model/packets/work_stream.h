// The work stream: what the functional GPU did, in logical coordinates and without time. The timing
// model, the heat maps and the trace exporters read it; it never changes a pixel.
//
// The functional GPU works through bins: a bin holds one or more draws and is carried out tile by
// tile. A consumer gets whole bins, and reads one either tile-major (as executed: for each tile its
// batches in order) or primitive-major (an immediate-mode machine: for each draw and primitive in
// order, the tiles it touched) with the help of WorkBin's index.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/texel_footprint.h"
#include "model/packets/window_vertex.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace ffgpu {

// Quads of one batch and the fate of their fragments. A fragment is live at first if covered; it
// ends at the first mask in which it is missing.
struct WorkQuad {
    std::uint32_t primitive;        // PrimitiveKey::primitive
    std::uint16_t x, y;             // window pixel of lane 0
    std::uint8_t covered;           // four bits each, bit i for lane i:
    std::uint8_t after_early_depth; // equals covered where depth is tested late
    std::uint8_t after_coverage;    // multisample operations took some samples, not all
    std::uint8_t after_alpha;
    std::uint8_t after_stencil;
    std::uint8_t after_depth; // what reaches the blend stage and is written
    // Multisampled targets: bit 4 i + s for sample s of lane i.
    std::uint16_t samples_covered = 0;
    std::uint16_t samples_written = 0; // passed all tests
};

// A batch of one tile. Quads are in the order of the primitives.
struct WorkBatch {
    std::uint32_t draw; // index into WorkBin::draws
    std::vector<WorkQuad> quads;
    std::vector<TexelFootprints> textures; // one entry a unit that the draw samples
};

struct WorkTile {
    std::uint16_t x, y; // lower left pixel
    std::vector<WorkBatch> batches;
};

// What became of a draw before rasterization. A draw that is split between bins has its work split,
// too: each part tells of the vertices and primitives since the part before.
struct GeometryWork {
    std::uint32_t vertex_bytes = 0;      // of one vertex in memory
    std::vector<std::uint32_t> vertices; // vertex numbers in the order of use, as indexed
    DeviceAddress vertex_address = 0;
    DeviceAddress index_address = 0;
    std::uint8_t index_bytes = 0; // of one index; 0: none
    std::uint32_t keys_begin =
        0;                      // PrimitiveKey::primitive of this part's primitives: a filled quad
    std::uint32_t keys_end = 0; // or polygon is one key and several primitives
    std::uint32_t primitives_in = 0;
    std::uint32_t primitives_clipped = 0;    // cut by a plane, at least one piece left
    std::uint32_t primitives_outside = 0;    // nothing left
    std::uint32_t primitives_culled = 0;     // by facing
    std::uint32_t primitives_degenerate = 0; // without area after snapping
    std::uint32_t primitives_out = 0;        // handed to triangle set-up
    std::uint8_t lights = 0;                 // enabled lights (0: lighting off)
};

enum class WorkKind : std::uint8_t { Draw, Image, Clear, Copy };

// One command that touches pixels, and the state it was done with.
struct WorkDraw {
    WorkKind kind = WorkKind::Draw;
    std::uint32_t number = 0; // PrimitiveKey::draw
    std::uint32_t frame = 0;
    bool early_depth = false; // Depth was tested before texturing.
    std::shared_ptr<const Registers> state{};
    GeometryWork geometry{};     // Draw
    ClearCommand clear{};        // Clear
    CopyRectangleCommand copy{}; // Copy
};

struct WorkBin {
    std::vector<WorkDraw> draws;
    std::vector<WorkTile> tiles; // In row order from the lower left; tiles without work are absent.
};

// Calls come from one thread, in the order of the commands. Clears and copies come as draws of
// their kind, in bins of their own or among others' draws, in order.
class WorkSink {
public:
    virtual ~WorkSink() = default;
    virtual void bin(const WorkBin& bin) = 0;
    // The driver wrote device memory (textures, vertices): what a real bus would carry.
    virtual void memory_written(DeviceAddress at, std::uint64_t bytes) = 0;
    virtual void memory_read(DeviceAddress at, std::uint64_t bytes) = 0;
    virtual void end_frame(std::uint32_t frame) = 0;
};

} // namespace ffgpu
