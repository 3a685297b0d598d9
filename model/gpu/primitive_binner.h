// PrimitiveBinner: a draw's primitives to set-up records in a bin. One for each thread that
// geometry runs on.

#pragma once

#include "model/gpu/bin.h"
#include "model/gpu/draw_context.h"
#include "model/gpu/raster_statistics.h"
#include "model/gpu/stages.h"
#include "model/packets/stage_probe.h"
#include "model/packets/window_vertex.h"
#include "model/packets/work_stream.h"
#include "model/raster/triangle_group.h"

#include <cstdint>
#include <memory>
#include <span>

namespace ffgpu {

// Where a draw goes on when its bin is full.
class BinSupply {
public:
    virtual ~BinSupply() = default;
    // One with room, behind those before it, that ends with a command of the same draw.
    virtual Bin& next_bin() = 0;
};

class PrimitiveBinner final : public PrimitiveSink {
public:
    explicit PrimitiveBinner(const Stages& stages)
        : stages_(stages) {}

    // Who is told of each primitive; null: nobody.
    struct Listeners {
        GeometryWork* work = nullptr;
        StageProbe* probe = nullptr;
    };

    // The primitives that come are those of the draw that `bin` ends with, or of a chunk of it.
    void start(const DrawContext& context, Bin& bin, BinSupply& supply, const Listeners& listeners);
    void primitives(std::span<const Primitive> batch) override;

    PrimitiveStatistics& statistics() { return statistics_; }
    const PrimitiveStatistics& statistics() const { return statistics_; }

private:
    void bin_triangles(std::span<const Primitive> triangles);
    void bin_triangle(const Primitive& triangle, unsigned place);
    void bin_primitive(const Primitive& primitive);
    SetupRecord& begin_record(const Primitive& primitive);
    void tell_set_up(const SetupRecord& record);
    void count_empty();
    void count_area(const Rectangle& box, double double_area);

    const Stages& stages_;
    const DrawContext* context_ = nullptr;
    Bin* bin_ = nullptr;
    BinSupply* supply_ = nullptr;
    Listeners listeners_;
    std::uint32_t last_key_ = 0, next_piece_ = 0;
    std::unique_ptr<TriangleGroup> group_ = std::make_unique<TriangleGroup>();
    PrimitiveStatistics statistics_;
};

} // namespace ffgpu
