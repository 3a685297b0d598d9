// ListVertices: glBegin ... glEnd while a display list is compiled. Whole primitives become vertex
// blocks; what cannot be known before the list is executed (vertices without their glBegin, another
// command in the midst of a primitive) is recorded call by call.

#pragma once

#include "driver/lists/display_list.h"
#include "driver/vertex/vertex_assembler.h"

#include <optional>

namespace ffgpu::gl {

class ListVertices final : public VertexAssembler {
public:
    // Begins a list. Nothing is known about the current attributes then.
    void start(DisplayList& list);

    void begin(GLenum mode) override;
    void end() override;
    void restart() override;
    void set_color_index(float value) override;
    // Of an array draw: vertices that it uses again stay shared.
    void indexed(const VertexRun& run, std::span<const std::uint32_t> indices) override;

    // Before an array draw is taken apart. False, and an error is in the list: it is in the midst
    // of a primitive.
    bool begin_array_draw();
    // Before a command of vertices.
    void begin_call() {
        if (array_draws_) settle();
    }

    // Before another command is recorded, and at the list's end: all vertices so far are in the
    // list.
    void settle();
    bool inside_primitive() const { return inside_ || raw_; }

    // A recorded command may change current attributes.
    void forget_current() { known_.fill(std::nullopt); }

private:
    void outside_attribute(Attribute attribute, unsigned components, const Vec4& value) override;
    void outside_vertex(unsigned components, const Vec4& position) override;
    bool enters(Attribute attribute, Vec4& before) override;
    void make_room(unsigned stride) override;

    using Values = std::array<Vec4, Attributes>;
    Values pending_values() const;
    void seal_block(const VertexFormat& set, const Values& last);
    void add_block(std::unique_ptr<VertexBlock> block);
    void record_attributes(const VertexFormat& set, const Values& values);
    void spill();
    void record_begin(GLenum mode);

    DisplayList* list_ = nullptr;
    GLenum mode_ = GL_POINTS;
    std::uint32_t first_ = 0;  // vertex of the primitive at hand
    bool raw_ = false;         // between a recorded glBegin and its glEnd
    bool array_draws_ = false; // The vertices at hand are theirs.
    std::vector<RunPrimitive> primitives_;
    std::array<std::uint32_t, Attributes> inherited_{};
    std::array<std::optional<Vec4>, Attributes> known_;

    // The attributes as they were at glBegin.
    VertexFormat begin_format_ = EmptyVertexFormat;
    Values begin_values_{};
};

} // namespace ffgpu::gl
