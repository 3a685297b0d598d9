// ImmediateVertices: glBegin ... glEnd as the application calls them. Vertices are collected; pairs
// that follow each other without a command between them that could matter are drawn together.

#pragma once

#include "driver/vertex/material_log.h"
#include "driver/vertex/vertex_assembler.h"

#include <vector>

namespace ffgpu::gl {

class VertexContext;

class ImmediateVertices final : public VertexAssembler {
public:
    explicit ImmediateVertices(VertexContext& context)
        : context_(context) {}

    void begin(GLenum mode) override;
    void end() override;
    void restart() override;
    void set_color_index(float value) override;
    void indexed(const VertexRun& run, std::span<const std::uint32_t> indices) override;

    // How many vertices wait.
    using VertexAssembler::count;

    // Draws what waits; the phase is Idle then. Not between glBegin and glEnd.
    void flush();

    // Between glBegin and glEnd: the vertices so far are drawn, and the primitive goes on.
    void cut();

    // The vertices to come have materials that differ from the state's, which those before have.
    // The caller then changes the state.
    void change_materials(const Materials& materials);

    // A value of the vertex under construction, or the current one.
    Vec4 value_of(Attribute attribute) const;

private:
    void outside_attribute(Attribute attribute, unsigned components, const Vec4& value) override;
    void outside_vertex(unsigned, const Vec4&) override {} // GL leaves it undefined.
    bool enters(Attribute attribute, Vec4& before) override;
    void make_room(unsigned stride) override;

    void store_current();
    void add_primitive(PrimitiveType type, std::uint32_t count);
    void close_loop();
    void add_edge_flags();
    void hide_edge(std::uint32_t n);
    void draw_primitives();

    static constexpr std::size_t LeastCapacity = 1u << 12; // words
    static constexpr std::size_t MostCapacity = 1u << 18;
    static constexpr std::size_t MaxPrimitives = 4096;

    VertexContext& context_;
    PrimitiveType type_ = PrimitiveType::Points;
    std::uint32_t first_ = 0; // vertex of the primitive at hand
    // The primitive at hand is not its first piece. The first vertex of a line loop then stands
    // before first_, until the loop is closed.
    bool was_cut_ = false;
    std::vector<float> carried_;
    std::vector<std::uint32_t> carried_from_;
    MaterialLog materials_;
    std::vector<RunPrimitive> primitives_;
};

} // namespace ffgpu::gl
