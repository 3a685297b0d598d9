#include "model/geometry/geometry_unit.h"

#include "model/device/extents.h"
#include "model/geometry/feedback_writer.h"

#include <algorithm>
#include <numeric>

namespace ffgpu {
namespace {

// Elements of a chunk, multiples of 12: whole triangles, quads and strips' steps. Vertices that are
// used again and again may be more, as few of them take a slot.
constexpr std::uint32_t PlainChunk = 1020;
constexpr std::uint32_t IndexedChunk = 4092;
constexpr std::uint32_t OutlineChunk = 516; // Polygons that are taken whole.
static_assert(IndexedChunk + 1 <= VertexPool::Capacity);

bool is_polygon(PrimitiveType type) {
    return type >= PrimitiveType::Triangles;
}

// Other polygons' edges are all boundaries (GL 1.5, 2.6.2).
bool has_edge_flags(PrimitiveType type) {
    return type == PrimitiveType::Triangles || type == PrimitiveType::Quads ||
           type == PrimitiveType::Polygon;
}

ElementChunks chunks_of(const DrawCommand& command, bool whole_polygons) {
    const bool outline = whole_polygons && command.primitive == PrimitiveType::Polygon;
    const bool indexed = command.index_type != IndexType::None;
    return {chunk_rule(command.primitive),
            command.count,
            outline   ? OutlineChunk
            : indexed ? IndexedChunk
                      : PlainChunk};
}

VertexNeeds vertex_needs(const PrimitiveSetup& registers, PrimitiveType type) {
    const auto either_mode = [&](PolygonMode mode) {
        return registers.front_mode == mode || registers.back_mode == mode;
    };
    const bool outlines = either_mode(PolygonMode::Point) || either_mode(PolygonMode::Line);
    VertexNeeds needs;
    needs.point_size =
        type == PrimitiveType::Points || (is_polygon(type) && either_mode(PolygonMode::Point));
    needs.edge_flag = has_edge_flags(type) && outlines;
    return needs;
}

void describe(const Registers& registers, const DrawCommand& command, GeometryWork& work) {
    work.vertex_bytes = 4u * registers.vertex_format.stride;
    work.vertex_address = command.vertex_address;
    work.index_address = command.index_address;
    work.index_bytes = static_cast<std::uint8_t>(index_bytes(command.index_type));
    if (!registers.lighting.enable) return;
    for (const Light& light : registers.lights)
        work.lights = static_cast<std::uint8_t>(work.lights + light.enable);
}

} // namespace

GeometryUnit::GeometryUnit(std::span<const std::byte> memory, ShadeVertices shade)
    : memory_(memory)
    , batch_(std::make_unique<VertexBatch>())
    , pool_(shade)
    , stage_(pool_, primitives_)
    , assembler_(pool_, stage_) {}

void GeometryUnit::reset() {
    stats_.reset();
    stage_.reset();
}

void GeometryUnit::draw(const DrawState& state,
                        const DrawCommand& command,
                        PrimitiveSink& sink,
                        GeometryWork* work) {
    feedback_ = nullptr;
    primitives_.start(&sink);
    run(state, state.layout, command, work);
}

void GeometryUnit::feedback(const DrawState& state,
                            const DrawCommand& command,
                            std::span<std::byte> memory) {
    if (!feedback_fits(command, memory.size())) {
        ++stats_.draws_dropped;
        return;
    }
    FeedbackWriter writer(memory.subspan(command.feedback_address, command.feedback_bytes));
    feedback_ = &writer;
    primitives_.start(nullptr);
    run(state, FeedbackWriter::layout(), command, nullptr);
    writer.finish();
    feedback_ = nullptr;
}

void GeometryUnit::run(const DrawState& state,
                       const InterpolantLayout& layout,
                       const DrawCommand& command,
                       GeometryWork* work) {
    const Registers& registers = state.regs();
    work_ = work;
    if (work) {
        describe(registers, command, *work);
        work->interpolants = layout.count;
    }
    if (command.count == 0) return;
    const ElementReader elements(memory_, command, registers.vertex_format);
    if (!elements.in_memory()) {
        ++stats_.draws_dropped;
        return;
    }
    ++stats_.draws;
    set_up(state, layout, vertex_needs(registers.primitive, command.primitive));
    if (!setup_.window.visible) return;
    stage_.start(setup_, feedback_, work);
    assembler_.start(command);
    const ElementChunks chunks = chunks_of(command, stage_.whole_polygons());
    for (std::uint32_t i = 0; i < chunks.count(); ++i)
        run_chunk(command, elements, chunks[i]);
    count_primitives();
}

std::uint32_t GeometryUnit::separate_chunks(const DrawState& state,
                                            const DrawCommand& command) const {
    const PrimitiveSetup& registers = state.regs().primitive;
    const bool filled =
        registers.front_mode == PolygonMode::Fill && registers.back_mode == PolygonMode::Fill;
    // A polygon's triangles share its number and are counted on.
    if (!filled || !is_polygon(command.primitive) || command.primitive == PrimitiveType::Polygon ||
        command.count == 0)
        return 1;
    const ElementChunks chunks = chunks_of(command, false);
    if (chunks.count() == 1) return 1;
    const ElementReader elements(memory_, command, state.regs().vertex_format);
    return elements.in_memory() ? chunks.count() : 1;
}

void GeometryUnit::begin_separate_chunks(const DrawState& state, const DrawCommand& command) {
    ++stats_.draws;
    set_up(state, state.layout, vertex_needs(state.regs().primitive, command.primitive));
    // The line stipple's counter goes on over a draw that nothing is seen of.
    if (setup_.window.visible) assembler_.start(command);
}

void GeometryUnit::draw_chunk(const DrawState& state,
                              const DrawCommand& command,
                              std::uint32_t chunk,
                              PrimitiveSink& sink) {
    feedback_ = nullptr;
    work_ = nullptr;
    primitives_.start(&sink);
    set_up(state, state.layout, vertex_needs(state.regs().primitive, command.primitive));
    if (!setup_.window.visible) return;
    stage_.start(setup_, nullptr, nullptr);
    assembler_.start(command);
    run_chunk(command,
              ElementReader(memory_, command, state.regs().vertex_format),
              chunks_of(command, false)[chunk]);
    count_primitives();
}

void GeometryUnit::set_up(const DrawState& state,
                          const InterpolantLayout& layout,
                          VertexNeeds needs) {
    if (registers_ == state.registers && setup_.layout == layout && setup_.needs == needs) return;
    registers_ = state.registers;
    setup_ = make_vertex_setup(*registers_, layout, needs);
    fetch_.start(setup_, *batch_);
    pool_.start(setup_);
}

void GeometryUnit::run_chunk(const DrawCommand& command,
                             const ElementReader& elements,
                             const ElementChunks::Chunk& chunk) {
    const std::uint32_t hub = chunk_rule(command.primitive).hub;
    elements_.resize(hub + chunk.end - chunk.begin);
    if (hub) elements.read(0, std::span(elements_).first(1));
    elements.read(chunk.begin, std::span(elements_).subspan(hub));
    if (work_)
        work_->vertices.insert(
            work_->vertices.end(), elements_.end() - chunk.fresh, elements_.end());
    stats_.vertices_fetched += chunk.fresh;

    make_slots(elements);
    shade_vertices(memory_.data() + command.vertex_address);
    assembler_.assemble({.slots = slots_,
                         .first = chunk.begin,
                         .is_first = chunk.begin == hub,
                         .is_last = chunk.end == command.count});
    primitives_.flush();
}

void GeometryUnit::make_slots(const ElementReader& elements) {
    slots_.resize(elements_.size());
    if (!elements.indexed()) {
        numbers_ = elements_;
        std::iota(slots_.begin(), slots_.end(), 0u);
        return;
    }
    numbers_.clear();
    reuse_.clear();
    std::transform(elements_.begin(), elements_.end(), slots_.begin(), [&](std::uint32_t number) {
        return reuse_.slot_of(number, numbers_);
    });
}

void GeometryUnit::shade_vertices(const std::byte* vertices) {
    const std::span<const std::uint32_t> numbers = numbers_;
    batch_->whole_chunk = numbers.size() <= BatchVertices;
    for (std::uint32_t slot = 0; slot < numbers.size(); slot += BatchVertices) {
        const std::size_t count = std::min<std::size_t>(BatchVertices, numbers.size() - slot);
        fetch_.fetch(vertices, numbers.subspan(slot, count), *batch_);
        pool_.shade(*batch_, slot);
    }
    stats_.vertices_shaded += numbers.size();
}

void GeometryUnit::count_primitives() {
    const PrimitiveCounts& counts = stage_.counts();
    stats_.primitives_in += counts.in;
    stats_.primitives_clipped += counts.clipped;
    stats_.primitives_outside += counts.outside;
    stats_.primitives_culled += counts.culled;
    stats_.primitives_degenerate += counts.degenerate;
    stats_.primitives_out += primitives_.handed_over();
    work_ = nullptr;
}

} // namespace ffgpu
