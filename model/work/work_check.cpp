#include "model/work/work_check.h"

#include "model/base/input_error.h"
#include "model/device/extents.h"
#include "model/device/validate.h"
#include "model/packets/quad_values.h"

namespace ffgpu::work {
namespace {

constexpr std::uint64_t AnyMemory = std::uint64_t{1} << 32; // The file does not tell its size.

} // namespace

void check_draw(const WorkDraw& draw) {
    if (draw.kind == WorkKind::Copy) return validate(draw.copy, AnyMemory);
    if (!draw.state) throw InputError("a command without state");
    validate(*draw.state, AnyMemory);
    if (draw.kind == WorkKind::Image) validate(draw.image, AnyMemory);
}

void check_pieces(const WholeCommand& command) {
    const GeometryWork& geometry = command.draw.geometry;
    if (geometry.primitives.empty()) return;
    auto quad = command.quads.begin();
    std::uint32_t key = ~0u, number = 0; // of the piece
    auto box = geometry.pieces.begin();
    for (const PrimitiveWork& primitive : geometry.primitives) {
        if (primitive.key != key) number = 0;
        key = primitive.key;
        for (std::uint32_t i = 0; i < primitive.pieces; ++i, ++number, ++box) {
            const auto inside = [&](const WorkQuad& q) {
                return q.x + 2 > box->x0 && q.x < box->x1 && q.y + 2 > box->y0 && q.y < box->y1;
            };
            for (; quad != command.quads.end() && quad->primitive == key && quad->piece == number;
                 ++quad)
                if (!inside(*quad)) throw InputError("a quad outside its primitive");
        }
    }
    if (quad != command.quads.end()) throw InputError("a quad of no primitive");
}

void check_surface(const Surface& surface) {
    if (surface.width > MaxSurfaceSize || surface.height > MaxSurfaceSize)
        throw InputError("a target exceeds the largest surface");
    if (!surface_fits(surface, AnyMemory)) throw InputError("there is no such surface");
}

bool values_fit(const WholeCommand& command, std::size_t number) {
    if (!command.draw.state) return false;
    const QuadValueKinds kinds = QuadValueKinds::of(*command.draw.state);
    const WorkQuad& quad = command.quads[number];
    QuadValues values;
    return QuadValues::parse(kinds,
                             covered_samples(quad, kinds.multisampled),
                             written_samples(quad, kinds.multisampled),
                             command.values_of(number),
                             values);
}

} // namespace ffgpu::work
