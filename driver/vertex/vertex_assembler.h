// VertexAssembler: makes vertices of glVertex, glColor, glNormal ... calls.
//
// Only the attributes that the application sets while the run lasts are in the run's format.
// glColor writes the four words that wait for the next vertex; glVertex copies those of all of
// them behind the others. An attribute that comes up later widens the format, and the vertices
// before get the value that was current for them.
//
// Immediate mode and the display-list compiler derive: they say what happens outside of
// glBegin/glEnd and when the buffer is full.

#pragma once

#include "driver/gl_types.h"
#include "driver/vertex/vertex_run.h"
#include "model/base/one_store.h"
#include "model/device/registers/geometry.h"

#include <cstring>
#include <vector>

namespace ffgpu::gl {

class VertexAssembler {
public:
    VertexAssembler() = default;
    virtual ~VertexAssembler() = default;
    VertexAssembler(const VertexAssembler&) = delete;
    VertexAssembler& operator=(const VertexAssembler&) = delete;

    virtual void begin(GLenum mode) = 0;
    virtual void end() = 0;
    virtual void restart() = 0; // NV_primitive_restart: an end and a begin of the same mode
    virtual void set_color_index(float value) = 0;
    // The run's only primitive, with indices into its words; nothing waits.
    virtual void indexed(const VertexRun& run, std::span<const std::uint32_t> indices) = 0;

    // Sets the first N components of an attribute, the others to 0, 0, 1.
    template <unsigned N>
    void set(Attribute attribute, float x, float y = 0, float z = 0, float w = 1) {
        if (format_.elements[attribute_index(attribute)].components != N) [[unlikely]]
            return set_other(attribute, N, {x, y, z, w});
        store_at_once(pending(attribute).data(), x, y, z, w);
    }

    template <unsigned N>
    void vertex(float x, float y, float z = 0, float w = 1) {
        if (room_ == 0 || format_.elements[0].components != N) [[unlikely]]
            return other_vertex(N, {x, y, z, w});
        put<N>(cursor_, x, y, z, w);
        finish_vertex();
    }

    // The same with a number of components that is not known before.
    void set(Attribute attribute, unsigned components, const Vec4& value);
    void vertex(unsigned components, const Vec4& position);

protected:
    // Outside of glBegin/glEnd, with no vertices waiting: the value becomes current.
    virtual void outside_attribute(Attribute attribute, unsigned components, const Vec4& v) = 0;
    virtual void outside_vertex(unsigned components, const Vec4& position) = 0;
    // `attribute`, which so far was not in the format, is about to enter it. Returns the value for
    // the vertices before. False: it must not; the attribute is then set again.
    virtual bool enters(Attribute attribute, Vec4& before) = 0;
    // Makes room for at least one more vertex of `stride` words, where there are count() already.
    virtual void make_room(unsigned stride) = 0;

    std::uint32_t count() const {
        return format_.stride == 0 ? 0 : static_cast<std::uint32_t>(used() / format_.stride);
    }
    std::size_t used() const { return static_cast<std::size_t>(cursor_ - words_.data()); }
    std::size_t capacity() const { return words_.empty() ? 0 : words_.size() - Slack; }
    void enlarge(std::size_t capacity);

    float* vertex_at(std::uint32_t i) { return words_.data() + std::size_t{i} * format_.stride; }
    std::span<const float> words() const { return {words_.data(), used()}; }

    // Takes the vertices from `count` on away.
    void keep_vertices(std::uint32_t count) { cursor_ = vertex_at(count); }
    // Vertices and format are empty then.
    void reset_run();

    // glVertex is taken from here on, until close().
    void open() { inside_ = true, update_room(); }
    void close() { inside_ = false, room_ = 0; }
    void update_room();

    // The value of an attribute of the format in the vertex under construction.
    Vec4 pending_value(Attribute attribute) const;
    // Brings `attribute` into the format with at least `components`; false if enters() refused.
    bool widen_format(Attribute attribute, unsigned components);

    VertexFormat format_ = EmptyVertexFormat;
    bool inside_ = false;

private:
    // finish_vertex() copies four words of each attribute, beyond the vertex's end if need be.
    static constexpr std::size_t Slack = 4;

    // An attribute behind the position, in the run's format.
    struct Placed {
        std::uint8_t attribute = 0, offset = 0;
    };

    template <unsigned N>
    static void put(float* to, float x, float y, float z, float w) {
        to[0] = x;
        if constexpr (N > 1) to[1] = y;
        if constexpr (N > 2) to[2] = z;
        if constexpr (N > 3) to[3] = w;
    }

    // Copies the attributes behind the position, which is written: whole, as they were written a
    // moment before (one_store.h). What is too much of one goes with the next.
    void finish_vertex() {
        // Once: the compiler cannot tell that a vertex does not lie over them.
        float* const vertex = cursor_;
        const unsigned count = placed_count_;
        for (unsigned i = 0; i < count; ++i)
            std::memcpy(
                vertex + placed_[i].offset, pending_[placed_[i].attribute].data(), sizeof(Vec4));
        cursor_ = vertex + format_.stride;
        --room_;
    }

    Vec4& pending(Attribute attribute) { return pending_[attribute_index(attribute)]; }
    void set_format(const VertexFormat& format);
    void set_other(Attribute attribute, unsigned components, const Vec4& value);
    void other_vertex(unsigned components, const Vec4& position);
    void convert_vertices(const VertexFormat& to, Attribute entering, const Vec4& before);

    std::uint32_t room_ = 0; // vertices that fit; 0 outside of glBegin/glEnd
    float* cursor_ = nullptr;
    alignas(16) std::array<Vec4, Attributes> pending_{}; // of the vertex under construction
    std::array<Placed, Attributes> placed_{};            // by their offsets
    unsigned placed_count_ = 0;
    std::vector<float> words_;
};

} // namespace ffgpu::gl
