#include "model/gpu/stage_tap.h"

namespace ffgpu {
namespace {

static_assert(probed::Coverage::Edges == MaxEdges);

// Calls visit(record, lane, x, y) for all lanes of the batch, x and y being the lane's pixel.
template <class Visit>
void for_each_lane(std::span<const probed::Run> runs, const FragmentBatch& batch, Visit&& visit) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        for (unsigned lane = 4 * runs[i].first_quad; lane < 4 * end; ++lane)
            visit(*runs[i].record,
                  lane,
                  batch.x[lane / 4] + static_cast<int>(lane & 1),
                  batch.y[lane / 4] + static_cast<int>(lane >> 1 & 1));
    }
}

// As the interpolator has it before w: an integer, and the plane's power of two.
double plane_value(const SetupRecord& record, const AttributePlane& plane, int x, int y) {
    const auto lane = static_cast<unsigned>((x & 1) + 2 * (y & 1));
    const std::int32_t corner =
        plane.corner((x & ~1) - record.x_reference, (y & ~1) - record.y_reference);
    return static_cast<double>(corner + plane.lane_offsets()[lane]) *
           static_cast<double>(plane.scale);
}

} // namespace

void StageTap::begin(const BinCommand& command, std::span<const BatchRun> runs) {
    covered_ = batch_.live;
    runs_.clear();
    for (const BatchRun& run : runs)
        runs_.push_back({run.record, run.first_quad});
    tap_.batch = {.draw = command.number,
                  .frame = command.frame,
                  .registers = &command.context->regs(),
                  .runs = runs_,
                  .fragments = &batch_};
    count_pieces();
    tap_.batch.pieces = pieces_;
}

// An image has no runs: the n-th of its quads at one place is piece n.
void StageTap::count_pieces() {
    pieces_.resize(batch_.quad_count);
    if (runs_.empty()) {
        const std::array<std::uint32_t, 3> tile{tap_.batch.draw, batch_.tile_x, batch_.tile_y};
        if (std::exchange(image_tile_, tile) != tile) image_quads_.clear();
        for (unsigned quad = 0; quad < batch_.quad_count; ++quad)
            pieces_[quad] = image_quads_[{batch_.y[quad], batch_.x[quad]}]++;
        return;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const unsigned end = i + 1 < runs_.size() ? runs_[i + 1].first_quad : batch_.quad_count;
        for (unsigned quad = runs_[i].first_quad; quad < end; ++quad)
            pieces_[quad] = runs_[i].record->piece;
    }
}

void StageTap::coverage() {
    coverage_ = {};
    for_each_lane(runs_, batch_, [&](const SetupRecord& record, unsigned lane, int x, int y) {
        for (unsigned i = 0; i < record.edge_count; ++i)
            coverage_.edges[i][lane] = record.edges[i].at(x, y);
    });
    tap_.probe.coverage(tap_.batch, coverage_);
}

void StageTap::perspective(const PerspectivePlanes& planes) {
    for_each_lane(runs_, batch_, [&](const SetupRecord& record, unsigned lane, int x, int y) {
        perspective_.inverse_w[lane] =
            record.perspective ? plane_value(record, record.inverse_w(), x, y) : 1;
    });
    std::copy_n(planes.w.begin(), perspective_.w.size(), perspective_.w.begin());
    tap_.probe.perspective(tap_.batch, perspective_);
}

void StageTap::plane_values(int first, unsigned count, std::span<probed::Lanes<double>> out) const {
    if (first < 0) return;
    for_each_lane(runs_, batch_, [&](const SetupRecord& record, unsigned lane, int x, int y) {
        for (unsigned i = 0; i < count; ++i)
            out[i][lane] =
                plane_value(record, record.plane(static_cast<unsigned>(first) + i), x, y);
    });
}

void StageTap::colors(const InterpolantLayout& layout) {
    plane_values(layout.color, 4, colors_.primary_over_w);
    plane_values(layout.secondary, 3, colors_.secondary_over_w);
    plane_values(layout.fog, 1, {&colors_.fog_over_w, 1});
    tap_.probe.colors(tap_.batch, colors_);
}

void StageTap::tex_coords(const InterpolantLayout& layout,
                          unsigned unit,
                          const TexCoordPlanes& result) {
    tex_coords_.unit = unit;
    tex_coords_.carried = layout.tex_coord[unit] < 0 ? 0u : layout.tex_components[unit];
    tex_coords_.result = &result;
    plane_values(layout.tex_coord[unit], tex_coords_.carried, tex_coords_.over_w);
    tap_.probe.tex_coords(tap_.batch, tex_coords_);
}

void StageTap::sampling(const TextureUnit& texture,
                        unsigned unit,
                        const TexCoordPlanes& coordinates) {
    probed::Sampling told =
        sampling_.run(texture, coordinates, {batch_.quad_count, covered_, batch_.live});
    told.unit = unit;
    told.result = &batch_.texture[unit];
    tap_.probe.sampling(tap_.batch, told);
}

} // namespace ffgpu
