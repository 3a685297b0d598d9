// GeometryUnit: a draw command to primitives in window space.
//
//     elements -> vertex numbers -> reuse -> fetch -> vertex stages -> pool      a chunk at a time
//     pool -> assembly -> clipping, facing, culling, modes -> PrimitiveSink
//
// Draws of any length go through in chunks of some thousand elements, so memory is bounded. A unit
// serves one thread; the chunks of one draw can be carried out by several units at once.

#pragma once

#include "model/base/statistics.h"
#include "model/device/commands.h"
#include "model/geometry/element_chunks.h"
#include "model/geometry/primitive_assembler.h"
#include "model/geometry/reuse_table.h"
#include "model/geometry/vertex_fetch.h"
#include "model/packets/draw_state.h"
#include "model/packets/work_stream.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu {

class GeometryUnit {
public:
    struct Stats : StatisticsGroup {
        Counter& draws = count("draws", "draws", "draws carried out");
        Counter& draws_dropped =
            count("draws_dropped", "draws", "draws that reached beyond device memory");
        Counter& vertices_fetched = count("vertices_fetched", "vertices", "elements of draws");
        Counter& vertices_shaded =
            count("vertices_shaded", "vertices", "vertices transformed and lit");
        Counter& primitives_in = count(
            "primitives_in", "primitives", "assembled; filled quads and polygons as triangles");
        Counter& primitives_clipped =
            count("primitives_clipped", "primitives", "cut by a plane, with something left");
        Counter& primitives_outside =
            count("primitives_outside", "primitives", "with nothing left inside the planes");
        Counter& primitives_culled = count("primitives_culled", "primitives", "culled by facing");
        Counter& primitives_degenerate =
            count("primitives_degenerate", "primitives", "without area or length after snapping");
        Counter& primitives_out =
            count("primitives_out", "primitives", "points, lines and triangles handed on");
    };

    // memory: all of device memory. shade: one of the forms of the vertex stages.
    explicit GeometryUnit(std::span<const std::byte> memory,
                          ShadeVertices shade = shade_vertices_simd);

    // Hands the draw's primitives to the sink. A draw that reaches beyond memory is dropped.
    // work: null where nobody listens.
    void draw(const DrawState& state,
              const DrawCommand& command,
              PrimitiveSink& sink,
              GeometryWork* work = nullptr);

    // How many chunks of the draw can be carried out apart, by several units and in any order:
    // together they hand over what draw() does, chunk after chunk. 1: it has to be one draw().
    std::uint32_t separate_chunks(const DrawState& state, const DrawCommand& command) const;
    // Once for such a draw, by the unit that carries out the draws before and after it.
    void begin_separate_chunks(const DrawState& state, const DrawCommand& command);
    void draw_chunk(const DrawState& state,
                    const DrawCommand& command,
                    std::uint32_t chunk,
                    PrimitiveSink& sink);

    // DrawOutput::Feedback: writes the draw's records into `memory`.
    void feedback(const DrawState& state, const DrawCommand& command, std::span<std::byte> memory);

    // Counters are zero, and so is the line stipple's.
    void reset();

    const Stats& statistics() const { return stats_; }
    Stats& statistics() { return stats_; }

private:
    void run(const DrawState& state,
             const InterpolantLayout& layout,
             const DrawCommand& command,
             GeometryWork* work);
    void set_up(const DrawState& state, const InterpolantLayout& layout, VertexNeeds needs);
    void run_chunk(const DrawCommand& command,
                   const ElementReader& elements,
                   const ElementChunks::Chunk& chunk);
    void make_slots(const ElementReader& elements);
    void shade_vertices(const std::byte* vertices);
    void count_primitives();

    std::span<const std::byte> memory_;
    Stats stats_;

    GeometryWork* work_ = nullptr; // of the draw under way

    // The set-up of the last draw, kept for the next one with the same registers.
    std::shared_ptr<const Registers> registers_;
    VertexSetup setup_;
    FeedbackOutput* feedback_ = nullptr;

    std::unique_ptr<VertexBatch> batch_;
    VertexFetch fetch_;
    VertexPool pool_;
    ReuseTable reuse_;
    PrimitiveBatch primitives_;
    PrimitiveStage stage_;
    PrimitiveAssembler assembler_;

    // Of the current chunk.
    std::vector<std::uint32_t> elements_; // their vertex numbers
    std::vector<std::uint32_t> slots_;    // their places in the pool
    std::vector<std::uint32_t> numbers_;  // vertex numbers by slot
};

} // namespace ffgpu
