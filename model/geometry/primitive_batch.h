// PrimitiveBatch: primitives on their way to the rasterizer, and the vertices made for them alone
// (clipped, or with the colours of another). Handed over in spans, to keep calls rare.

#pragma once

#include "model/packets/window_vertex.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

class PrimitiveBatch {
public:
    static constexpr std::size_t Primitives = 512;
    static constexpr std::size_t Vertices = 2048;

    PrimitiveBatch();

    // Begins anew, whatever an exception left of the draw before.
    void start(PrimitiveSink* sink) {
        sink_ = sink;
        count_ = vertices_used_ = 0;
        handed_over_ = 0;
    }

    // Makes room: what is added next, up to these numbers, is not handed over before all of it
    // has been added.
    void reserve(std::size_t primitives, std::size_t vertices) {
        if (count_ + primitives > primitives_.size() ||
            vertices_used_ + vertices > vertices_.size())
            make_room(primitives, vertices);
    }

    void add(const Primitive& primitive) { primitives_[count_++] = primitive; }
    WindowVertex& new_vertex() { return vertices_[vertices_used_++]; }

    // Hands everything over; vertices made until now are gone.
    void flush();

    std::uint64_t handed_over() const { return handed_over_ + count_; }

private:
    void make_room(std::size_t primitives, std::size_t vertices);

    PrimitiveSink* sink_ = nullptr;
    std::vector<Primitive> primitives_;
    std::size_t count_ = 0;
    std::vector<WindowVertex> vertices_;
    std::size_t vertices_used_ = 0;
    std::uint64_t handed_over_ = 0;
};

} // namespace ffgpu
