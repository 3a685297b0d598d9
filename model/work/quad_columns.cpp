#include "model/work/quad_columns.h"

#include "model/work/access_columns.h"
#include "model/work/quad_fate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace ffgpu::work {
namespace {

// What a quad takes at most in each column, without its accesses and values.
constexpr std::size_t MostOfFate = 6, MostOfSamples = 1 + 2 * MostOfStep;
constexpr std::size_t MostOfQuad = 4 * MostOfNumber + 1 + MostOfFate + MostOfSamples;

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

// Of some quads a number each, and all bits that any has.
struct Numbers {
    std::array<std::uint32_t, QuadColumnWriter::MostQuads> of;
    std::uint32_t any = 0;

    void set(std::size_t quad, std::uint32_t number) {
        of[quad] = number;
        any |= number;
    }
    void write(Column column, std::size_t count, ColumnWriter& columns) const {
        std::uint8_t* to = columns.room(column, count * MostOfNumber);
        if (any < 0x80) { // Each is a byte.
            for (std::size_t i = 0; i < count; ++i)
                to[i] = static_cast<std::uint8_t>(of[i]);
            return columns.written(column, to + count);
        }
        for (std::size_t i = 0; i < count; ++i)
            to = put_number(to, of[i]);
        columns.written(column, to);
    }
};

std::uint32_t zigzag_step(int step) {
    return static_cast<std::uint32_t>(step) << 1 ^ static_cast<std::uint32_t>(step >> 31);
}

// Where they are, each from the one before.
void write_places(const WholeCommand& command,
                  std::size_t first,
                  std::size_t count,
                  ColumnWriter& columns) {
    Numbers primitive, piece, row, column;
    const WorkQuad none{};
    const WorkQuad* before = first == 0 ? &none : &command.quads[first - 1];
    const WorkQuad* const quads = command.quads.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
        const WorkQuad& quad = quads[i];
        const std::uint32_t primitives = quad.primitive - before->primitive;
        primitive.set(i, primitives);
        piece.set(i, quad.piece - (primitives == 0 ? before->piece : 0));
        row.set(i, zigzag_step(quad.y / 2 - before->y / 2));
        column.set(i, zigzag_step(quad.x / 2 - before->x / 2 - (quad.y == before->y ? 1 : 0)));
        before = &quad;
    }
    primitive.write(Column::Primitive, count, columns);
    piece.write(Column::Piece, count, columns);
    row.write(Column::Row, count, columns);
    column.write(Column::Column, count, columns);
}

// What became of their fragments.
void write_fates(std::span<const WorkQuad> quads, ColumnWriter& columns) {
    std::uint8_t* covered = columns.room(Column::Covered, quads.size());
    std::uint8_t* fate = columns.room(Column::Fate, quads.size() * MostOfFate);
    std::uint8_t* samples = columns.room(Column::Samples, quads.size() * MostOfSamples);
    for (const WorkQuad& quad : quads) {
        *covered++ = quad.covered;
        fate = put_fate(fate, quad);
        samples = put_samples(samples, quad);
    }
    columns.written(Column::Covered, covered);
    columns.written(Column::Fate, fate);
    columns.written(Column::Samples, samples);
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
    return count *
               (MostOfQuad + command.units.size() * MostOfNumber + most_accesses_ * MostOfAccess) +
           values * MostOfNumber;
}

void QuadColumnWriter::write(const WholeCommand& command,
                             std::size_t first,
                             std::size_t count,
                             ColumnWriter& columns) {
    write_places(command, first, count, columns);
    write_fates(std::span(command.quads).subspan(first, count), columns);
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
    const AccessCursors end = put_accesses(
        {command, first, count},
        forecast_,
        {columns.room(Column::AccessCount, count * command.units.size() * MostOfNumber),
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
