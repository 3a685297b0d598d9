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
    read_masks(quad);
    read_samples(quad);
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

void WorkFileQuads::read_masks(WorkQuad& quad) {
    const auto mask = [this] { return static_cast<std::uint8_t>(in_.number(Column::Fate, 0xf)); };
    switch (static_cast<QuadFate>(in_.byte(Column::Fate))) {
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

void WorkFileQuads::read_samples(WorkQuad& quad) {
    switch (static_cast<SampleFate>(in_.byte(Column::Samples))) {
    case SampleFate::None:
        break;
    case SampleFate::Whole:
        quad.samples_covered = whole_samples(quad.covered);
        quad.samples_written = whole_samples(quad.after_depth);
        break;
    case SampleFate::Other:
        quad.samples_covered = static_cast<std::uint16_t>(in_.number(Column::Samples, 0xffff));
        quad.samples_written = static_cast<std::uint16_t>(in_.number(Column::Samples, 0xffff));
        break;
    default:
        throw DamagedItem("there is no such fate of samples");
    }
}

void WorkFileQuads::read_accesses(WholeCommand& command) {
    for (std::size_t unit = 0; unit < command.units.size(); ++unit) {
        forecast_.begin_quad(command.units[unit]);
        const std::uint64_t count = in_.number(Column::AccessCount, MostAccesses);
        for (std::uint64_t i = 0; i < count; ++i)
            command.add_access(unit, read_access());
    }
}

TexelAccess WorkFileQuads::read_access() {
    const std::uint8_t shape = in_.byte(Column::Shape);
    TexelAccess access{};
    access.lane = shape & 3;
    access.linear = shape >> 2 & 7;
    const AccessForecast::Expected expected = forecast_.next(access.lane);
    access.x0 = moved(expected.x, in_.difference(Column::X));
    access.y0 = moved(expected.y, in_.difference(Column::Y));
    access.level = expected.level;
    access.layer0 = expected.layer;
    access.x1 = moved(access.x0, access.linear & 1);
    access.y1 = moved(access.y0, access.linear >> 1 & 1);
    if ((shape & ShapeForeseen) == 0) {
        access.level = in_.byte(Column::Rare);
        access.x1 = moved(access.x1, in_.difference(Column::Rare));
        access.y1 = moved(access.y1, in_.difference(Column::Rare));
        access.layer0 = moved(access.layer0, in_.difference(Column::Rare));
        access.layer1 =
            moved(moved(access.layer0, access.linear >> 2), in_.difference(Column::Rare));
    } else {
        access.layer1 = moved(access.layer0, access.linear >> 2);
    }
    forecast_.take(access);
    return access;
}

} // namespace ffgpu::work
