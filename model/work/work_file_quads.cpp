#include "model/work/work_file_quads.h"

#include "model/packets/fragment_key.h"
#include "model/work/quad_fate.h"
#include "model/work/work_check.h"

namespace ffgpu::work {
namespace {

// Of a quad in one unit: an elliptic filter takes under 8500.
constexpr std::uint64_t MostAccesses = 1 << 14;

// `from + by`, in units of two pixels.
std::uint16_t quad_place(std::int64_t from, std::int64_t by) {
    const std::int64_t place = from + by;
    if (place < 0 || place > MaxSurfaceSize / 2)
        throw DamagedItem("a quad lies outside any surface");
    return static_cast<std::uint16_t>(2 * place);
}

void read_masks(ColumnReader& in, WorkQuad& quad) {
    const auto mask = [&in] { return static_cast<std::uint8_t>(in.number(Column::Fate, 0xf)); };
    switch (static_cast<QuadFate>(in.byte(Column::Fate))) {
    case QuadFate::AllWritten:
        set_masks(quad, quad.covered, quad.covered);
        break;
    case QuadFate::DeadEarly:
        break;
    case QuadFate::SurvivorsWrite: {
        const std::uint8_t left = mask();
        set_masks(quad, left, left);
        break;
    }
    case QuadFate::Other:
        for (std::uint8_t* const to : {&quad.after_early_depth,
                                       &quad.after_coverage,
                                       &quad.after_alpha,
                                       &quad.after_stencil,
                                       &quad.after_depth})
            *to = mask();
        break;
    default:
        throw DamagedItem("there is no such fate of a quad");
    }
}

void read_samples(ColumnReader& in, WorkQuad& quad) {
    switch (static_cast<SampleFate>(in.byte(Column::Samples))) {
    case SampleFate::None:
        break;
    case SampleFate::Whole:
        quad.samples_covered = whole_samples(quad.covered);
        quad.samples_written = whole_samples(quad.after_depth);
        break;
    case SampleFate::Other:
        quad.samples_covered = static_cast<std::uint16_t>(in.number(Column::Samples, 0xffff));
        quad.samples_written = static_cast<std::uint16_t>(in.number(Column::Samples, 0xffff));
        break;
    default:
        throw DamagedItem("there is no such fate of samples");
    }
}

constexpr std::uint32_t pair(std::uint16_t low, std::uint16_t high) {
    return low | std::uint32_t{high} << 16;
}

// The next access of the quad whose lane 0 is `first_lane`.
AccessPlane::AccessWords
read_access(ColumnReader& in, AccessForecast::Quad& forecast, unsigned first_lane) {
    const std::uint8_t shape = in.byte(Column::Shape);
    const unsigned lane = shape & 3, linear = shape >> 2 & 7;
    const AccessForecast::Expected expected = forecast.next(lane);
    const std::uint16_t x0 = moved(expected.x, in.difference(Column::X));
    const std::uint16_t y0 = moved(expected.y, in.difference(Column::Y));
    std::uint16_t x1 = moved(x0, linear & 1), y1 = moved(y0, linear >> 1 & 1);
    std::uint8_t level = expected.level;
    std::uint16_t layer0 = expected.layer, layer1 = moved(layer0, linear >> 2);
    if ((shape & ShapeForeseen) == 0) {
        level = in.byte(Column::Rare);
        x1 = moved(x1, in.difference(Column::Rare));
        y1 = moved(y1, in.difference(Column::Rare));
        layer0 = moved(layer0, in.difference(Column::Rare));
        layer1 = moved(moved(layer0, linear >> 2), in.difference(Column::Rare));
    }
    forecast.take({.x = x0, .y = y0, .level = level, .layer = layer0});
    const auto head = static_cast<std::uint16_t>(level | linear << 8);
    return {pair(static_cast<std::uint16_t>(first_lane + lane), head),
            pair(x0, x1),
            pair(y0, y1),
            pair(layer0, layer1)};
}

} // namespace

void WorkFileQuads::append_quad(WholeCommand& command) {
    const WorkQuad before = command.quads.empty() ? WorkQuad{} : command.quads.back();
    WorkQuad quad{};
    quad.primitive = before.primitive + in_.word(Column::Primitive);
    const std::uint32_t piece = quad.primitive == before.primitive ? before.piece : 0;
    quad.piece = piece + in_.word(Column::Piece);
    quad.y = quad_place(before.y / 2, in_.difference(Column::Row));
    quad.x =
        quad_place(before.x / 2 + (quad.y == before.y ? 1 : 0), in_.difference(Column::Column));
    quad.covered = static_cast<std::uint8_t>(in_.number(Column::Covered, 0xf));
    read_masks(in_, quad);
    read_samples(in_, quad);
    if (!command.quads.empty() && !comes_before(before, quad))
        throw DamagedItem("quads are not in their order");
    command.quads.push_back(quad);
    read_accesses(command);
    if (command.has_values()) read_values(command);
}

void WorkFileQuads::read_values(WholeCommand& command) {
    values_in_.append_words(in_, command.values);
    command.value_begin.push_back(static_cast<std::uint32_t>(command.values.size()));
    if (!values_fit(command, command.quads.size() - 1))
        throw DamagedItem("a quad's values are too few or too many");
}

void WorkFileQuads::read_accesses(WholeCommand& command) {
    for (std::size_t unit = 0; unit < command.units.size(); ++unit) {
        const std::uint64_t count = in_.number(Column::AccessCount, MostAccesses);
        if (count == 0) continue;
        AccessForecast::Quad forecast = forecast_.quad(command.units[unit]);
        TexelFootprints& read = command.own_footprints(unit);
        const unsigned first_lane = command.first_lane();
        for (std::uint64_t i = 0; i < count; ++i)
            read.add(read_access(in_, forecast, first_lane));
    }
}

} // namespace ffgpu::work
