#include "model/work/quad_columns.h"

#include "model/work/access_columns.h"
#include "model/work/quad_fate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

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

// What is written of some quads, quad by quad.
struct QuadNumbers {
    // Of one kind, and all their bits.
    struct Numbers {
        std::array<std::uint32_t, QuadColumnWriter::MostQuads> of;
        std::uint32_t any = 0;

        void set(std::size_t i, std::uint32_t number) {
            of[i] = number;
            any |= number;
        }
    };
    Numbers primitive, piece, row, column;
    std::uint32_t any_killed = 0;  // bits of masks that are not as the covered one
    std::uint32_t any_samples = 0; // Targets have several samples a pixel.
};

void tell(std::span<const WorkQuad> quads, const WorkQuad* before, QuadNumbers& numbers) {
    std::size_t i = 0;
    for (const WorkQuad& quad : quads) {
        const int row = quad.y / 2 - before->y / 2;
        const std::uint32_t primitive = quad.primitive - before->primitive;
        numbers.primitive.set(i, primitive);
        numbers.piece.set(i, quad.piece - (primitive == 0 ? before->piece : 0));
        numbers.row.set(i, static_cast<std::uint32_t>(zigzag(row)));
        numbers.column.set(i,
                           static_cast<std::uint32_t>(
                               zigzag(quad.x / 2 - before->x / 2 - (quad.y == before->y ? 1 : 0))));
        for (const std::uint8_t mask : {quad.after_early_depth,
                                        quad.after_coverage,
                                        quad.after_alpha,
                                        quad.after_stencil,
                                        quad.after_depth})
            numbers.any_killed |= static_cast<std::uint32_t>(mask ^ quad.covered);
        numbers.any_samples |= quad.samples_covered | static_cast<unsigned>(quad.samples_written);
        before = &quad;
        ++i;
    }
}

void write_numbers(const QuadNumbers::Numbers& numbers,
                   std::size_t count,
                   Column column,
                   ColumnWriter& columns) {
    std::uint8_t* to = columns.room(column, MostOfNumber * count);
    if (numbers.any < 0x80) // Each is a byte.
        to = std::transform(numbers.of.begin(),
                            numbers.of.begin() + count,
                            to,
                            [](std::uint32_t number) { return static_cast<std::uint8_t>(number); });
    else
        for (std::size_t i = 0; i < count; ++i)
            to = put_number(to, numbers.of[i]);
    columns.written(column, to);
}

// In `column`, what put(to, quad) puts for each; or `usual`, if that is so of all.
template <class Put>
void write_outcomes(std::span<const WorkQuad> quads,
                    std::optional<std::uint8_t> usual,
                    std::pair<Column, std::size_t> column_and_most,
                    ColumnWriter& columns,
                    Put&& put) {
    const auto [column, most] = column_and_most;
    std::uint8_t* to = columns.room(column, most * quads.size());
    if (usual)
        to = std::fill_n(to, quads.size(), *usual);
    else
        for (const WorkQuad& quad : quads)
            to = put(to, quad);
    columns.written(column, to);
}

void write_places(const WholeCommand& command,
                  std::size_t first,
                  std::size_t count,
                  ColumnWriter& columns) {
    const auto quads = std::span(command.quads).subspan(first, count);
    const WorkQuad none{};
    QuadNumbers numbers;
    tell(quads, first == 0 ? &none : &command.quads[first - 1], numbers);
    write_numbers(numbers.primitive, count, Column::Primitive, columns);
    write_numbers(numbers.piece, count, Column::Piece, columns);
    write_numbers(numbers.row, count, Column::Row, columns);
    write_numbers(numbers.column, count, Column::Column, columns);
    std::uint8_t* to = columns.room(Column::Covered, count);
    for (const WorkQuad& quad : quads)
        *to++ = quad.covered;
    columns.written(Column::Covered, to);
    const auto usual = [](bool all, auto value) {
        return all ? std::optional(static_cast<std::uint8_t>(value)) : std::nullopt;
    };
    write_outcomes(quads,
                   usual(numbers.any_killed == 0, QuadFate::AllWritten),
                   {Column::Fate, MostOfFate},
                   columns,
                   put_fate);
    write_outcomes(quads,
                   usual(numbers.any_samples == 0, SampleFate::None),
                   {Column::Samples, MostOfSamples},
                   columns,
                   put_samples);
}

} // namespace

std::size_t
QuadColumnWriter::most_bytes(const WholeCommand& command, std::size_t first, std::size_t count) {
    const std::size_t units = command.units.size(), end = first + count;
    const std::size_t accesses = command.accesses.words(first * units, end * units);
    const std::size_t values =
        command.has_values() ? count + command.value_begin[end] - command.value_begin[first] : 0;
    return count * (MostOfQuad + units * MostOfNumber) + accesses * MostOfAccess +
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
    const std::size_t units = command.units.size();
    const std::size_t most = command.accesses.words(first * units, (first + count) * units);
    const AccessCursors end =
        put_accesses({command.accesses, first, count, command.units},
                     forecast_,
                     {columns.room(Column::AccessCount, count * units * MostOfNumber),
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
