// TriangleGroup: set-up of up to eight filled triangles at once, a lane a triangle. set_up() is the
// specification; triangles that need more than the lanes can do are left to it, one by one.

#pragma once

#include "model/raster/setup.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu {

struct TriangleGroup {
    static constexpr unsigned Size = 8;
    template <class T>
    using Each = std::array<T, Size>;
    using Bits = std::uint8_t; // a bit a triangle

    Bits alone = 0;   // set_up() has to do it: nothing else holds of it.
    Bits empty = 0;   // What set_up() returns false for.
    Bits nothing = 0; // SetupRecord::covers_nothing: it has box and area only.

    Bits perspective = 0, constant_color = 0, constant_secondary = 0;
    alignas(64) Each<double> double_area; // ffgpu::double_area(), positive
    alignas(64) Each<Rectangle> box;
    alignas(64) std::array<Each<Edge>, 3> edges;
    alignas(64) Each<std::uint32_t> edge_fractions; // a byte an edge
    alignas(64) Each<DepthPlane> depth;
    alignas(64) Each<std::uint32_t> depth_min, depth_max;
    alignas(64) Each<std::int32_t> x_reference, y_reference, inverse_w_floor;
    alignas(64) Each<std::uint32_t> color, secondary; // a byte a channel
    // By the layout, and of 1 / w behind them. Those of a colour that is constant in all triangles
    // are not made.
    alignas(64) std::array<Each<StoredPlane>, MaxInterpolants + 1> planes;
};

// Whether a draw's triangles may go in groups: they cover pixels' centres, have no depth offset
// and no stipple.
bool goes_in_groups(const SetupContext& context);

// 1 to TriangleGroup::Size triangles.
void set_up_triangles(const SetupContext& context,
                      std::span<const Primitive> triangles,
                      TriangleGroup& group);

// The specification: set_up() does all of it.
void set_up_triangles_scalar(const SetupContext& context,
                             std::span<const Primitive> triangles,
                             TriangleGroup& group);

using SetUpTriangles = void (*)(const SetupContext&, std::span<const Primitive>, TriangleGroup&);

// Triangle i, which covers something and is not alone, as set_up() leaves its record.
void write_record(const SetupContext& context,
                  const TriangleGroup& group,
                  unsigned i,
                  const Primitive& triangle,
                  SetupRecord& record);

} // namespace ffgpu
