// The work stream as the functional GPU hands it over: what it did, in logical coordinates and
// without time; it never changes a pixel.
//
// It comes in pieces that follow the host: a WorkBin is what was carried out at once, tile by tile,
// and ends where the host's memory for bins did, even within a draw. model/work makes whole
// commands of it again, in an order and with keys in which nothing of the host is left; who counts,
// times or files work reads those. A WorkBin is never changed once it is handed over: readers share
// it, on any thread.

#pragma once

#include "model/base/chunk_memory.h"
#include "model/device/commands.h"
#include "model/device/registers.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/texel_footprint.h"
#include "model/packets/window_vertex.h"

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <vector>

namespace ffgpu {

// Quads of one batch and the fate of their fragments. A fragment is live at first if covered; it
// ends at the first mask in which it is missing.
struct WorkQuad {
    std::uint32_t primitive;        // PrimitiveKey::primitive
    std::uint32_t piece = 0;        // SetupRecord::piece
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

    bool operator==(const WorkQuad&) const = default;
};

// A batch of one tile. Quads are in the order of the primitives.
struct WorkBatch {
    std::uint32_t draw = 0; // index into WorkBin::draws
    std::pmr::vector<WorkQuad> quads{};
    std::pmr::vector<TexelFootprints> textures{}; // one entry a unit that the draw samples
    // With WorkDetail::Values: those of quad q are values[value_begin[q]] up to the next quad's
    // (quad_values.h), and the footprints are those of all covered fragments, also of the ones that
    // the early depth test ended. Both empty without.
    std::pmr::vector<std::uint32_t> value_begin{};
    std::pmr::vector<std::uint32_t> values{};
};

struct WorkTile {
    std::uint16_t x, y; // lower left pixel
    std::vector<WorkBatch> batches;
};

enum class PrimitiveFate : std::uint8_t {
    Drawn,      // pieces of it came to set-up
    Outside,    // nothing was left inside the planes
    Culled,     // by facing
    Degenerate, // without area or length after snapping
};

// A primitive as assembled, and what became of it. A filled quad or polygon is several, its
// triangles, of one key.
struct PrimitiveWork {
    std::uint32_t key = 0;         // PrimitiveKey::primitive
    std::uint32_t last_vertex = 0; // place in GeometryWork::vertices: it is assembled after this
    std::uint32_t pieces = 0;      // points, lines and triangles of it that came to set-up
    std::uint8_t planes = 0;       // that it was clipped against; 0: all inside, or all outside one
    PrimitiveFate fate = PrimitiveFate::Drawn;

    bool operator==(const PrimitiveWork&) const = default;
};

// The pixels that a piece may cover: what a rasterizer has to walk. Empty: it cannot cover any. And
// what set-up made of the piece.
struct PieceBox {
    static constexpr unsigned BlockWidth = 8; // pixels

    std::uint16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0; // half open
    std::uint32_t touched_blocks = 0;             // that neither box nor an edge rules out as a
                                                  // whole; 0: no quad will be found
    // Attributes that vary over the piece, each with a plane. Those are values that quads get, and
    // q of texture units; `divisors` are w and the q that are not 1 at every vertex.
    std::uint8_t planes = 0; // with that of 1/w
    std::uint8_t values = 0, divisors = 0;
    bool perspective = false; // There is a plane of 1/w.
    bool handed_on = false; // Not yet known to set-up as one that covers no pixel: those it drops.

    bool empty() const { return x0 == x1; }
    bool operator==(const PieceBox&) const = default;
};

// What became of a draw before rasterization: of the whole draw, whatever bins it was drawn in.
struct GeometryWork {
    std::uint32_t vertex_bytes = 0;      // of one vertex in memory
    std::vector<std::uint32_t> vertices; // vertex numbers in the order of use, as indexed
    DeviceAddress vertex_address = 0;
    DeviceAddress index_address = 0;
    std::uint8_t index_bytes = 0;          // of one index; 0: none
    std::uint8_t lights = 0;               // enabled lights (0: lighting off)
    std::uint8_t interpolants = 0;         // attributes that set-up makes planes of, beside depth
    std::vector<PrimitiveWork> primitives; // in the order of assembly
    std::vector<PieceBox> pieces;          // of all primitives, one behind the other

    // All but the lists.
    template <class Self, class Visitor>
    static void for_each_number(Self& self, Visitor&& number) {
        number(self.vertex_bytes);
        number(self.vertex_address);
        number(self.index_address);
        number(self.index_bytes);
        number(self.lights);
        number(self.interpolants);
    }
};

enum class WorkKind : std::uint8_t { Draw, Image, Clear, Copy };

// One command that touches pixels, and the state it was done with.
struct WorkDraw {
    WorkKind kind = WorkKind::Draw;
    std::uint32_t number = 0; // PrimitiveKey::draw
    std::uint32_t frame = 0;
    bool early_depth = false; // Depth was tested before texturing.
    // What the host sent to set the state, since the command before.
    std::uint32_t register_writes = 0, register_words = 0;
    std::shared_ptr<const Registers> state{};
    GeometryWork geometry{};     // Draw
    DrawImageCommand image{};    // Image
    ClearCommand clear{};        // Clear
    CopyRectangleCommand copy{}; // Copy
};

// The driver wrote or read device memory (textures, vertices, pictures): what a real bus carries.
struct HostTransfer {
    std::uint32_t before_draw = 0; // It came before this one of the bin's draws.
    bool is_write = true;
    DeviceAddress at = 0;
    std::uint64_t bytes = 0;
};

// With WorkDetail::Values: what a target holds that is used for the first time, or again after
// something else than draws and clears may have written its bytes. Rows from the lowest, without
// gaps, sample 0 of all pixels first.
struct SurfaceContent {
    std::uint32_t before_draw = 0; // It is so before this one of the bin's draws.
    Surface surface;
    std::vector<std::byte> bytes;
};

struct WorkBin {
    std::vector<std::shared_ptr<ChunkMemory>> memory; // of the batches; goes after them
    std::vector<WorkDraw> draws;
    std::vector<HostTransfer> transfers;                         // in their order
    std::vector<std::shared_ptr<const SurfaceContent>> contents; // with values; in their order
    std::vector<WorkTile> tiles; // In row order from the lower left; tiles without work are absent.
    bool last_draw_goes_on = false; // The next bin begins with more quads of it; its geometry is
                                    // told where it ends.
};

// What is recorded: which fragments were written, or also with which values (quad_values.h).
enum class WorkDetail : std::uint8_t { Masks, Values };

// Calls come one after another, in the order of the commands. Clears and copies come as draws of
// their kind.
class WorkSink {
public:
    virtual ~WorkSink() = default;
    virtual void bin(std::shared_ptr<const WorkBin> bin) = 0;
    virtual void end_frame(std::uint32_t frame) = 0;
};

} // namespace ffgpu
