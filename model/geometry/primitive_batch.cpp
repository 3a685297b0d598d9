#include "model/geometry/primitive_batch.h"

namespace ffgpu {

PrimitiveBatch::PrimitiveBatch()
    : primitives_(Primitives)
    , vertices_(Vertices) {}

void PrimitiveBatch::flush() {
    if (count_ != 0 && sink_) sink_->primitives(std::span(primitives_).first(count_));
    handed_over_ += count_;
    count_ = 0;
    vertices_used_ = 0;
}

// More than is there at first is asked for only by polygons with very many corners.
void PrimitiveBatch::make_room(std::size_t primitives, std::size_t vertices) {
    flush();
    if (primitives > primitives_.size()) primitives_.resize(primitives);
    if (vertices > vertices_.size()) vertices_.resize(vertices);
}

} // namespace ffgpu
