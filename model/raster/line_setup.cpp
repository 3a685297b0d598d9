// Lines. Width 1 without smoothing follows the diamond-exit rule to the letter (GL 1.5, 3.4.1),
// with its perturbation of end points by (-e, -e^2); wider ones replicate it along the minor axis.
//
// Along its major axis u a line makes one fragment a column, on the row v in which it crosses the
// column's centre: two parallel edges. Which columns is decided at either end by the diamonds: they
// become the box. Smooth and multisampled lines are rectangles.

#include "model/raster/plane_setup.h"
#include "model/raster/sample_positions.h"
#include "model/raster/shape_setup.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ffgpu {
namespace {

constexpr std::int32_t One = 1 << SubPixelBits;
constexpr std::int32_t Half = One / 2;
constexpr float MaxLineWidth = 1024;

// A line in axes along and across its major direction.
struct MajorLine {
    bool x_major;
    SubPixelPoint from, to; // .x is u, .y is v

    int direction() const { return to.x >= from.x ? 1 : -1; }
};

MajorLine major_line(const WindowVertex& a, const WindowVertex& b) {
    const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    return x_major ? MajorLine{true, {a.x, a.y}, {b.x, b.y}}
                   : MajorLine{false, {a.y, a.x}, {b.y, b.x}};
}

// The pixel of a coordinate that the perturbation moved down by next to nothing.
int perturbed_pixel(std::int32_t at) {
    return (at - 1) >> SubPixelBits;
}

// Position inside the perturbed pixel relative to its centre, in 1/256: -127 to 128.
std::int32_t from_centre(std::int32_t at) {
    return at - ((perturbed_pixel(at) << SubPixelBits) + Half);
}

// Inside the open diamond |u| + |v| < 1/2 around the centre of the point's own pixel. On its
// boundary the perturbation decides, that of x: to the left.
bool inside_diamond(const MajorLine& line, SubPixelPoint point) {
    const std::int32_t u = from_centre(point.x), v = from_centre(point.y);
    const std::int32_t distance = std::abs(u) + std::abs(v);
    if (distance != Half) return distance < Half;
    return (line.x_major ? u : v) > 0;
}

struct Columns {
    int first, last; // in the line's direction
};

// A column counts where the line crosses its centre, or where it only leaves the diamond after it.
Columns columns_of(const MajorLine& line) {
    const int direction = line.direction();
    const auto before_centre = [direction](std::int32_t u) {
        return direction > 0 ? from_centre(u) <= 0 : from_centre(u) > 0;
    };
    Columns columns{perturbed_pixel(line.from.x), perturbed_pixel(line.to.x)};
    if (!before_centre(line.from.x) && !inside_diamond(line, line.from)) columns.first += direction;
    if (before_centre(line.to.x) || inside_diamond(line, line.to)) columns.last -= direction;
    return columns;
}

// The edges of the rows v - (width - 1) .. v that a column has, v the line's height at its centre.
void set_up_rows(const MajorLine& line, int width, SetupRecord& record) {
    const int direction = line.direction();
    const std::int32_t du = std::abs(line.to.x - line.from.x);
    const std::int32_t dv = (line.to.y - line.from.y) * direction;
    const bool row_owns_lower = line.x_major && dv > 0; // Where the line runs on a row boundary.
    const std::int64_t height =
        std::int64_t{du} * line.from.y + std::int64_t{dv} * (Half - line.from.x);
    const auto edge = [&](std::int32_t along, std::int32_t across, std::int64_t c) {
        return line.x_major ? Edge{along, across, c} : Edge{across, along, c};
    };
    const std::int64_t lower = (height - (row_owns_lower ? 0 : 1)) >> SubPixelBits;
    const std::int64_t upper = (-height - (row_owns_lower ? 1 : 0)) >> SubPixelBits;
    record.edges[0] = edge(dv, -du, lower + std::int64_t{width - 1} * du);
    record.edges[1] = edge(-dv, du, upper + du);
    record.edge_count = 2;
}

int rounded_width(float width) {
    if (!(width > 1)) return 1;
    return static_cast<int>(std::min(width, MaxLineWidth) + 0.5f);
}

bool set_up_aliased(const SetupContext& context, MajorLine line, SetupRecord& record) {
    const int width = rounded_width(context.primitive.line_width);
    const std::int32_t shift = (width - 1) * Half;
    line.from.y -= shift;
    line.to.y -= shift;
    const Columns columns = columns_of(line);
    if ((columns.last - columns.first) * line.direction() < 0) return false;

    const auto [left, right] = std::minmax({columns.first, columns.last});
    const auto [low, high] =
        std::minmax({perturbed_pixel(line.from.y), perturbed_pixel(line.to.y)});
    const Rectangle box = line.x_major ? Rectangle{left, low - 1, right + 1, high + width + 1}
                                       : Rectangle{low - 1, left, high + width + 1, right + 1};
    record.box = intersect(box, context.clip);
    set_up_rows(line, width, record);
    record.stipple_start = columns.first;
    return !record.box.empty();
}

// The rectangle of the line's width around it (GL 1.5, 3.4.2): covered by area where the line is
// smooth, sample by sample in multisampled targets (3.4.4).
bool set_up_rectangle(const SetupContext& context,
                      const Primitive& primitive,
                      SetupRecord& record) {
    const WindowVertex& a = *primitive.vertices[0];
    const WindowVertex& b = *primitive.vertices[1];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0) return false;
    const float width = context.primitive.line_width;
    const double half_width =
        Half * static_cast<double>(width > 0 ? std::min(width, MaxLineWidth) : 1.0f);
    const auto round = [](double value) {
        return static_cast<std::int32_t>(value + (value < 0 ? -0.5 : 0.5));
    };
    const std::int32_t nx = round(-dy / length * half_width), ny = round(dx / length * half_width);

    record.corners = {
        {{a.x - nx, a.y - ny}, {b.x - nx, b.y - ny}, {b.x + nx, b.y + ny}, {a.x + nx, a.y + ny}}};
    Rectangle box{a.x, a.y, a.x, a.y};
    for (unsigned i = 0; i < 4; ++i) {
        const SubPixelPoint corner = record.corners[i];
        record.set_edge(i, make_exact_edge(corner, record.corners[(i + 1) % 4]));
        box = {std::min(box.x0, corner.x),
               std::min(box.y0, corner.y),
               std::max(box.x1, corner.x),
               std::max(box.y1, corner.y)};
    }
    record.edge_count = 4;
    record.coverage = context.multisample ? CoverageKind::Samples : CoverageKind::SmoothPolygon;
    record.stipple_start = perturbed_pixel(major_line(a, b).from.x);
    const Rectangle touched = context.multisample
                                  ? sampled_pixels({box.x0, box.y0}, {box.x1, box.y1})
                                  : Rectangle{box.x0 >> SubPixelBits,
                                              box.y0 >> SubPixelBits,
                                              (box.x1 + One - 1) >> SubPixelBits,
                                              (box.y1 + One - 1) >> SubPixelBits};
    record.box = intersect(touched, context.clip);
    return !record.box.empty();
}

} // namespace

bool set_up_line(const SetupContext& context, const Primitive& primitive, SetupRecord& record) {
    const WindowVertex& a = *primitive.vertices[0];
    const WindowVertex& b = *primitive.vertices[1];
    const MajorLine line = major_line(a, b);
    const bool drawn = context.primitive.line_smooth || context.multisample
                           ? set_up_rectangle(context, primitive, record)
                           : set_up_aliased(context, line, record);
    if (!drawn) return false;
    if (context.primitive.line_stipple) {
        record.stipple = line.x_major ? StippleKind::LineX : StippleKind::LineY;
        record.stipple_direction = line.direction();
        record.stipple_counter = primitive.stipple_counter;
    }

    const float width = context.primitive.line_width;
    set_up_planes(
        context, line_geometry(a, b, width > 0 ? std::min(width, MaxLineWidth) : 1), record);
    if (primitive.from_polygon && context.primitive.offset_line) {
        const WindowVertex* const third = primitive.vertices[2];
        const PlaneVertices plane{&a, &b, third ? third : &a};
        add_depth_offset(context, plane, third ? triangle_basis(plane) : line_basis(a, b), record);
    }
    return true;
}

} // namespace ffgpu
