#include "model/geometry/clipper.h"

#include <algorithm>

namespace ffgpu {
namespace {

std::array<double, 4> widen(const Vec4& v) {
    return {v[0], v[1], v[2], v[3]};
}

std::array<double, 4>
interpolate(const std::array<double, 4>& a, const std::array<double, 4>& b, double t) {
    std::array<double, 4> result;
    for (unsigned i = 0; i < 4; ++i)
        result[i] = a[i] + t * (b[i] - a[i]);
    return result;
}

// NaN, of a viewport that is not finite, is the low end, as in the vertex stage.
double within(double low, double value, double high) {
    return std::min(std::max(low, value), high);
}

// 24.8, rounded to nearest even.
std::int32_t snap(double pixels) {
    constexpr double Limit = GuardBand * (1 << SubPixelBits);
    constexpr double RoundToInteger = 0x1.8p52;
    const double clamped = within(-Limit, pixels * (1 << SubPixelBits), Limit);
    return static_cast<std::int32_t>((clamped + RoundToInteger) - RoundToInteger);
}

} // namespace

void Clipper::start(const VertexSetup& setup) {
    setup_ = &setup;
    clear();
}

std::uint32_t Clipper::add(std::uint32_t slot, const Vec4& clip, const Vec4& eye) {
    ClipVertex vertex{.clip = widen(clip), .eye = {}, .slot = slot};
    if (setup_->registers->clip_planes.enable != 0) vertex.eye = widen(eye);
    vertices_.push_back(vertex);
    return vertex_count() - 1;
}

// w first: behind it all ratios to w are positive multiples.
std::span<const Clipper::Plane> Clipper::planes_for(ClipCode codes, Bounds bounds) {
    using namespace clip_code;
    unsigned count = 0;
    const auto plane = [&](std::array<double, 4> normal) { planes_[count++] = {normal, 0, false}; };
    if (codes & SmallW) planes_[count++] = {{0, 0, 0, 1}, -double{LeastW}, false};
    if (codes & Near) plane({0, 0, 1, 1});
    if (codes & Far) plane({0, 0, -1, 1});
    for (unsigned i = 0; i < ClipPlanes; ++i)
        if (codes >> (FirstUserBit + i) & 1)
            planes_[count++] = {widen(setup_->registers->clip_planes.planes[i]), 0, true};

    const WindowSetup& window = setup_->window;
    const bool exact = bounds == Bounds::Exact;
    if (codes & (exact ? Sides | Left | Right | Bottom | Top : Sides)) {
        const auto low = [exact](float limit) { return exact ? std::max(limit, -1.0f) : limit; };
        const auto high = [exact](float limit) { return exact ? std::min(limit, 1.0f) : limit; };
        plane({1, 0, 0, -double{low(window.low_x)}});
        plane({-1, 0, 0, high(window.high_x)});
        plane({0, 1, 0, -double{low(window.low_y)}});
        plane({0, -1, 0, high(window.high_y)});
    }
    planes_used_ += count;
    return std::span(planes_).first(count);
}

double Clipper::distance(const Plane& plane, std::uint32_t number) const {
    const ClipVertex& vertex = vertices_[number];
    const std::array<double, 4>& v = plane.in_eye_space ? vertex.eye : vertex.clip;
    const std::array<double, 4>& n = plane.normal;
    return (n[0] * v[0] + n[1] * v[1]) + (n[2] * v[2] + n[3] * v[3]) + plane.constant;
}

std::uint32_t Clipper::cut(std::uint32_t inner,
                           std::uint32_t outer,
                           double inner_distance,
                           double outer_distance) {
    const double t = inner_distance / (inner_distance - outer_distance);
    ClipVertex vertex{.clip = interpolate(vertices_[inner].clip, vertices_[outer].clip, t),
                      .eye = interpolate(vertices_[inner].eye, vertices_[outer].eye, t)};
    vertex.made = true;
    vertex.from = inner;
    vertex.to = outer;
    vertex.t = t;
    vertices_.push_back(vertex);
    return vertex_count() - 1;
}

// Sutherland and Hodgman's step (1974). The new edge along the plane is a boundary edge.
void Clipper::cut_polygon(const Plane& plane) {
    next_.clear();
    const std::size_t size = polygon_.size();
    double here = size != 0 ? distance(plane, polygon_[0].vertex) : 0;
    const double first = here;
    for (std::size_t i = 0; i < size; ++i) {
        const ClipCorner corner = polygon_[i];
        const bool is_last = i + 1 == size;
        const std::uint32_t following = polygon_[is_last ? 0 : i + 1].vertex;
        const double there = is_last ? first : distance(plane, following);
        if (here >= 0) next_.push_back(corner);
        if (here >= 0 && there < 0)
            next_.push_back({cut(corner.vertex, following, here, there), true});
        if (here < 0 && there >= 0)
            next_.push_back({cut(following, corner.vertex, there, here), corner.boundary});
        here = there;
    }
    polygon_.swap(next_);
}

std::span<const ClipCorner>
Clipper::clip_polygon(std::span<const ClipCorner> polygon, ClipCode codes, Bounds bounds) {
    polygon_.assign(polygon.begin(), polygon.end());
    for (const Plane& plane : planes_for(codes, bounds))
        cut_polygon(plane);
    return polygon_;
}

void Clipper::cut_edges(std::span<const ClipCorner> corners, const Plane& plane, ClipCode name) {
    ++planes_used_;
    next_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ClipCorner corner = corners[i];
        const std::uint32_t following = corners[i + 1 == corners.size() ? 0 : i + 1].vertex;
        const double here = distance(plane, corner.vertex), there = distance(plane, following);
        next_.push_back(corner);
        if ((here < 0) == (there < 0) || here == 0 || there == 0) continue;
        const std::uint32_t made = here > 0 ? cut(corner.vertex, following, here, there)
                                            : cut(following, corner.vertex, there, here);
        vertices_[made].depth_plane = name;
        next_.push_back({made, corner.boundary});
    }
    polygon_.swap(next_);
}

std::span<const ClipCorner> Clipper::cut_at_depths(std::span<const ClipCorner> corners,
                                                   ClipCode codes) {
    using namespace clip_code;
    if (codes & BeforeNear) {
        cut_edges(corners, {{0, 0, 1, 1}, 0, false}, BeforeNear);
        corners = polygon_;
    }
    if (codes & BeyondFar) {
        cut_edges(corners, {{0, 0, -1, 1}, 0, false}, BeyondFar);
        corners = polygon_;
    }
    return corners;
}

bool Clipper::is_of_part(std::uint32_t number, ClipCode part) const {
    using namespace clip_code;
    const ClipVertex& vertex = vertices_[number];
    if (vertex.depth_plane != 0) return part == 0 || part == vertex.depth_plane;
    const double z = vertex.clip[2], w = vertex.clip[3];
    if (part == BeforeNear) return z <= -w;
    if (part == BeyondFar) return z >= w;
    return z >= -w && z <= w;
}

bool Clipper::clip_line(std::uint32_t& a, std::uint32_t& b, ClipCode codes) {
    for (const Plane& plane : planes_for(codes, Bounds::Exact)) {
        const double at_a = distance(plane, a), at_b = distance(plane, b);
        if (at_a < 0 && at_b < 0) return false;
        if (at_a < 0) a = cut(b, a, at_b, at_a);
        if (at_b < 0) b = cut(a, b, at_a, at_b);
    }
    return true;
}

void Clipper::project(std::uint32_t number, WindowVertex& vertex) const {
    const auto& [x, y, z, clipped_w] = vertices_[number].clip;
    const double w = std::max(clipped_w, double{LeastW}); // A cut near 0 may round below.
    const auto window = [&](unsigned axis, double coordinate) {
        return double{setup_->window.scale[axis]} * (coordinate / w) +
               double{setup_->window.offset[axis]};
    };
    vertex.x = snap(window(0, x));
    vertex.y = snap(window(1, y));
    vertex.depth = static_cast<float>(
        within(setup_->window.low_depth, window(2, z), setup_->window.high_depth));
    vertex.inverse_w = static_cast<float>(1 / w);
}

} // namespace ffgpu
