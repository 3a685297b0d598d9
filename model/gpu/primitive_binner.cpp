#include "model/gpu/primitive_binner.h"

#include "model/gpu/piece_work.h"

#include <algorithm>

namespace ffgpu {
namespace {

// Twice what a primitive would cover, about: exact for triangles inside the clip rectangle.
double double_area_of(const SetupRecord& record) {
    constexpr double Pixel = 2 << 2 * SubPixelBits;
    if (record.edge_count != 3) return Pixel * record.box.width() * record.box.height();
    const Edge& first = record.edges[0];
    const Edge& last = record.edges[2];
    return static_cast<double>(std::int64_t{first.b} * last.a - std::int64_t{last.b} * first.a);
}

// Triangles at the beginning, as many as a group takes.
std::size_t leading_triangles(std::span<const Primitive> batch) {
    std::size_t count = 0;
    while (count < std::min<std::size_t>(batch.size(), TriangleGroup::Size) &&
           batch[count].shape == PrimitiveShape::Triangle)
        ++count;
    return count;
}

PieceBox piece_box(const Rectangle& box) {
    const auto narrow = [](int at) { return static_cast<std::uint16_t>(at); };
    return {narrow(box.x0), narrow(box.y0), narrow(box.x1), narrow(box.y1)};
}

} // namespace

void PrimitiveBinner::start(const DrawContext& context,
                            Bin& bin,
                            BinSupply& supply,
                            const Listeners& listeners) {
    context_ = &context;
    bin_ = &bin;
    supply_ = &supply;
    listeners_ = listeners;
    last_key_ = next_piece_ = 0;
}

void PrimitiveBinner::primitives(std::span<const Primitive> batch) {
    constexpr std::size_t Few = 2; // A group takes its time, however many there are.
    const bool in_groups = !listeners_.probe && goes_in_groups(context_->setup);
    while (!batch.empty()) {
        const std::size_t triangles = in_groups ? leading_triangles(batch) : 0;
        if (triangles > Few) {
            bin_triangles(batch.first(triangles));
            batch = batch.subspan(triangles);
        } else {
            bin_primitive(batch.front());
            batch = batch.subspan(1);
        }
    }
}

void PrimitiveBinner::bin_triangles(std::span<const Primitive> triangles) {
    stages_.set_up_triangles(context_->setup, triangles, *group_);
    for (unsigned i = 0; i < triangles.size(); ++i)
        bin_triangle(triangles[i], i);
}

// That at `place` of the group.
void PrimitiveBinner::bin_triangle(const Primitive& triangle, unsigned place) {
    const TriangleGroup& group = *group_;
    const auto is = [place](TriangleGroup::Bits bits) { return (bits >> place & 1) != 0; };
    if (is(group.alone)) return bin_primitive(triangle);
    SetupRecord& record = begin_record(triangle);
    if (is(group.empty)) return count_empty();
    count_area(group.box[place], group.double_area[place]);
    if (is(group.nothing)) return;
    write_record(context_->setup, group, place, triangle, record);
    tell_set_up(record);
    bin_->insert();
}

// Room for the record of the primitive that is next, with its piece's number.
SetupRecord& PrimitiveBinner::begin_record(const Primitive& primitive) {
    if (bin_->full()) bin_ = &supply_->next_bin();
    ++statistics_.primitives;
    if (primitive.key != last_key_) next_piece_ = 0;
    last_key_ = primitive.key;
    SetupRecord& record = bin_->next_record();
    record.piece = next_piece_++;
    return record;
}

void PrimitiveBinner::bin_primitive(const Primitive& primitive) {
    SetupRecord& record = begin_record(primitive);
    const bool covers = set_up(context_->setup, primitive, record, listeners_.probe != nullptr);
    if (listeners_.probe)
        listeners_.probe->set_up({.draw = bin_->commands().back().number,
                                  .frame = bin_->commands().back().frame,
                                  .registers = &context_->regs(),
                                  .primitive = &primitive,
                                  .record = covers ? &record : nullptr});
    if (!covers) return count_empty();
    count_area(record.box, double_area_of(record));
    if (record.covers_nothing) return;
    tell_set_up(record);
    bin_->insert();
}

// Of the piece that was counted last.
void PrimitiveBinner::tell_set_up(const SetupRecord& record) {
    if (listeners_.work) add_set_up(context_->setup.layout, record, listeners_.work->pieces.back());
}

void PrimitiveBinner::count_empty() {
    ++statistics_.empty;
    if (listeners_.work) listeners_.work->pieces.push_back({});
}

// double_area: in square sub-pixels, twice.
void PrimitiveBinner::count_area(const Rectangle& box, double double_area) {
    constexpr double PerPixel = 1.0 / (2 << 2 * SubPixelBits);
    statistics_.add_area(double_area * PerPixel);
    if (!listeners_.work) return;
    listeners_.work->pieces.push_back(piece_box(box));
    const auto pixels = std::uint64_t(box.width()) * std::uint64_t(box.height());
    bin_->add_told_pixels(std::min(pixels, static_cast<std::uint64_t>(double_area * PerPixel) + 1));
}

} // namespace ffgpu
