#include "driver/vertex/face_draw.h"

#include "driver/math/matrix.h"
#include "driver/vertex/draw_path.h"
#include "driver/vertex/vertex_context.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace ffgpu::gl {

namespace {

double determinant(const Vec4& a, const Vec4& b, const Vec4& c) {
    const auto at = [](const Vec4& v, unsigned i) { return static_cast<double>(v[i]); };
    return at(a, 0) * (at(b, 1) * at(c, 3) - at(c, 1) * at(b, 3)) -
           at(b, 0) * (at(a, 1) * at(c, 3) - at(c, 1) * at(a, 3)) +
           at(c, 0) * (at(a, 1) * at(b, 3) - at(b, 1) * at(a, 3));
}

class FaceDraw {
public:
    FaceDraw(VertexContext& context, const VertexFormat& format, const std::vector<float>& words)
        : context_(context)
        , format_(format)
        , words_(words)
        , vertices_(static_cast<std::uint32_t>(words.size() / format.stride / 2)) {
        const Transform& matrices = context.registers.wanted.transform;
        const unsigned components = format.elements[0].components;
        clip_.reserve(vertices_);
        for (std::size_t i = 0; i < vertices_; ++i) {
            Vec4 position = MissingComponents;
            std::copy_n(words.data() + i * format.stride, components, position.begin());
            clip_.push_back(
                transform(matrices.projection, transform(matrices.model_view, position)));
        }
    }

    // Strips and fans become separate triangles and quads, their corners in the device's order.
    void draw(const RunPrimitive& primitive) {
        const std::uint32_t n = primitive.count;
        switch (primitive.type) {
        case PrimitiveType::Triangles:
            for (std::uint32_t i = 0; i + 2 < n; i += 3)
                add({i, i + 1, i + 2});
            break;
        case PrimitiveType::TriangleStrip:
            for (std::uint32_t i = 0; i + 2 < n; ++i)
                add({i + i % 2, i + 1 - i % 2, i + 2});
            break;
        case PrimitiveType::TriangleFan:
            for (std::uint32_t i = 1; i + 1 < n; ++i)
                add({0, i, i + 1});
            break;
        case PrimitiveType::Quads:
            for (std::uint32_t i = 0; i + 3 < n; i += 4)
                add({i, i + 1, i + 2, i + 3});
            break;
        case PrimitiveType::QuadStrip:
            for (std::uint32_t i = 0; i + 3 < n; i += 2)
                add({i + 2, i, i + 1, i + 3});
            break;
        default:
            return draw_polygon(primitive);
        }
        const bool is_quads = primitive.type >= PrimitiveType::Quads;
        const RunPrimitive whole{
            .type = is_quads ? PrimitiveType::Quads : PrimitiveType::Triangles,
            .count = static_cast<std::uint32_t>(indices_.size()),
        };
        context_.draw_path().draw_indexed({format_, words_, {&whole, 1}}, indices_);
    }

private:
    void add(std::initializer_list<std::uint32_t> corners) {
        area_ = 0;
        for (auto corner = corners.begin() + 1; corner + 1 < corners.end(); ++corner)
            add_area(*corners.begin(), corner[0], corner[1]);
        const std::uint32_t offset = shows_back() ? vertices_ : 0;
        for (const std::uint32_t corner : corners)
            indices_.push_back(corner + offset);
    }

    void draw_polygon(const RunPrimitive& primitive) {
        area_ = 0;
        for (std::uint32_t i = 1; i + 1 < vertices_; ++i)
            add_area(0, i, i + 1);
        const std::size_t half = words_.size() / 2;
        const std::span<const float> words(words_.data() + (shows_back() ? half : 0), half);
        context_.draw_path().draw({format_, words, {&primitive, 1}});
    }

    // Twice the area of a triangle in window coordinates, but for a factor; of one that is partly
    // behind the eye the sign, which is that of the part before it.
    void add_area(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const Vec4 &a = clip_[i], &b = clip_[j], &c = clip_[k];
        const double value = determinant(a, b, c);
        const bool is_visible = a[3] > 0 && b[3] > 0 && c[3] > 0;
        area_ += is_visible ? value / static_cast<double>(a[3] * b[3] * c[3]) : value;
    }

    bool shows_back() const {
        return context_.registers.wanted.primitive.front_is_clockwise ? area_ >= 0 : area_ <= 0;
    }

    VertexContext& context_;
    const VertexFormat& format_;
    const std::vector<float>& words_;
    const std::uint32_t vertices_;
    std::vector<Vec4> clip_;
    std::vector<std::uint32_t> indices_;
    double area_ = 0;
};

// Of strips and fans every edge is a boundary, whatever their vertices' flags.
bool needs_edge_flags(const VertexContext& context, PrimitiveType type) {
    const PrimitiveSetup& setup = context.registers.wanted.primitive;
    const bool shows_edges =
        setup.front_mode != PolygonMode::Fill || setup.back_mode != PolygonMode::Fill;
    return shows_edges && (type == PrimitiveType::TriangleStrip ||
                           type == PrimitiveType::TriangleFan || type == PrimitiveType::QuadStrip);
}

} // namespace

void draw_by_face(VertexContext& context,
                  const VertexFormat& format,
                  const std::vector<float>& words,
                  const RunPrimitive& primitive) {
    if (!needs_edge_flags(context, primitive.type))
        return FaceDraw(context, format, words).draw(primitive);

    const VertexFormat wide = widen(format, Attribute::EdgeFlag, 1);
    const unsigned flag = wide.elements[attribute_index(Attribute::EdgeFlag)].offset;
    std::vector<float> flagged(words.size() / format.stride * wide.stride);
    for (std::size_t from = 0, to = 0; from < words.size();
         from += format.stride, to += wide.stride) {
        convert_vertex(format, wide, words.data() + from, flagged.data() + to);
        flagged[to + flag] = 1;
    }
    FaceDraw(context, wide, flagged).draw(primitive);
}

} // namespace ffgpu::gl
