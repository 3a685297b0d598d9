#include "model/work/quad_columns.h"

#include "model/work/access_columns.h"
#include "model/work/quad_fate.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace ffgpu::work {
namespace {

// What a quad takes at most in each column, without its accesses and values.
constexpr std::size_t MostOfFate = 6, MostOfSamples = 1 + 2 * MostOfStep;
constexpr std::size_t MostOfQuad = 4 * MostOfNumber + 1 + MostOfFate + MostOfSamples;

// In `column`, what tell(to, quad, quad before) puts for each.
template <class Tell>
void write_column(const WholeCommand& command,
                  std::size_t first,
                  std::size_t count,
                  ColumnWriter& columns,
                  Column column,
                  std::size_t most,
                  Tell&& tell) {
    std::uint8_t* to = columns.room(column, most * count);
    const WorkQuad none{};
    const WorkQuad* before = first == 0 ? &none : &command.quads[first - 1];
    for (const WorkQuad& quad : std::span(command.quads).subspan(first, count)) {
        to = tell(to, quad, *before);
        before = &quad;
    }
    columns.written(column, to);
}

std::uint8_t* put_fate(std::uint8_t* to, const WorkQuad& quad) {
    const QuadFate fate = fate_of(quad);
    *to++ = static_cast<std::uint8_t>(fate);
    if (fate == QuadFate::SurvivorsWrite) *to++ = quad.after_depth;
    if (fate != QuadFate::Other) return to;
    for (const std::uint8_t mask : {quad.after_early_depth,
                                    quad.after_coverage,
                                    quad.after_alpha,
                                    quad.after_stencil,
                                    quad.after_depth})
        *to++ = mask;
    return to;
}

std::uint8_t* put_samples(std::uint8_t* to, const WorkQuad& quad) {
    const SampleFate samples = sample_fate_of(quad);
    *to++ = static_cast<std::uint8_t>(samples);
    if (samples != SampleFate::Other) return to;
    to = put_number(to, quad.samples_covered);
    return put_number(to, quad.samples_written);
}

void write_places(const WholeCommand& command,
                  std::size_t first,
                  std::size_t count,
                  ColumnWriter& columns) {
    const auto column = [&](Column to, std::size_t most, auto&& tell) {
        write_column(command, first, count, columns, to, most, tell);
    };
    using Byte = std::uint8_t;
    using Quad = const WorkQuad&;
    column(Column::Primitive, MostOfNumber, [](Byte* to, Quad quad, Quad before) {
        return put_number(to, quad.primitive - before.primitive);
    });
    column(Column::Piece, MostOfNumber, [](Byte* to, Quad quad, Quad before) {
        return put_number(to, quad.piece - (quad.primitive == before.primitive ? before.piece : 0));
    });
    column(Column::Row, MostOfNumber, [](Byte* to, Quad quad, Quad before) {
        return put_number(to, zigzag(quad.y / 2 - before.y / 2));
    });
    column(Column::Column, MostOfNumber, [](Byte* to, Quad quad, Quad before) {
        return put_number(to, zigzag(quad.x / 2 - before.x / 2 - (quad.y == before.y ? 1 : 0)));
    });
    column(Column::Covered, 1, [](Byte* to, Quad quad, Quad) {
        *to = quad.covered;
        return to + 1;
    });
    column(Column::Fate, MostOfFate, [](Byte* to, Quad quad, Quad) { return put_fate(to, quad); });
    column(Column::Samples, MostOfSamples, [](Byte* to, Quad quad, Quad) {
        return put_samples(to, quad);
    });
}

} // namespace

void QuadColumnWriter::begin(const WholeCommand& command) {
    std::size_t planes = 0;
    for (const TexelFootprints* const read : command.footprints)
        if (read) planes = std::max(planes, read->planes.size());
    most_accesses_ = 4 * planes * command.units.size();
}

std::size_t QuadColumnWriter::most_bytes(const WholeCommand& command,
                                         std::size_t first,
                                         std::size_t count) const {
    const std::size_t end = first + count;
    const std::size_t values =
        command.has_values() ? count + command.value_begin[end] - command.value_begin[first] : 0;
    return count * (MostOfQuad + command.units.size() * MostOfNumber +
                    most_accesses_ * MostOfAccess) +
           values * MostOfNumber;
}

void QuadColumnWriter::write(const WholeCommand& command,
                             std::size_t first,
                             std::size_t count,
                             ColumnWriter& columns) {
    write_places(command, first, count, columns);
    if (!command.units.empty()) write_accesses(command, first, count, columns);
    if (!command.has_values()) return;
    for (std::size_t quad = first; quad < first + count; ++quad)
        values_.words(columns, command.values_of(quad));
}

void QuadColumnWriter::write_accesses(const WholeCommand& command,
                                      std::size_t first,
                                      std::size_t count,
                                      ColumnWriter& columns) {
    const std::size_t most = count * most_accesses_;
    const AccessCursors end =
        put_accesses({command, first, count},
                     forecast_,
                     {columns.room(Column::AccessCount,
                                   count * command.units.size() * MostOfNumber),
                      columns.room(Column::Shape, most),
                      columns.room(Column::X, most * MostOfStep),
                      columns.room(Column::Y, most * MostOfStep),
                      columns.room(Column::Rare, most * MostOfRare)});
    columns.written(Column::AccessCount, end.number);
    columns.written(Column::Shape, end.shape);
    columns.written(Column::X, end.x);
    columns.written(Column::Y, end.y);
    columns.written(Column::Rare, end.rare);
}

} // namespace ffgpu::work
