#include "model/work/command_assembler.h"

#include <array>
#include <cstddef>
#include <utility>

namespace ffgpu::work {
namespace {

void append_values(const WorkBatch& batch, std::uint32_t quad, WholeCommand& whole) {
    const auto at = [&](std::uint32_t q) {
        return batch.values.begin() + static_cast<std::ptrdiff_t>(batch.value_begin[q]);
    };
    whole.values.insert(whole.values.end(), at(quad), at(quad + 1));
    whole.value_begin.push_back(static_cast<std::uint32_t>(whole.values.size()));
}

std::size_t count_accesses(std::span<const WorkBatch* const> batches) {
    std::size_t accesses = 0;
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            accesses += unit.accesses.size();
    return accesses;
}

std::vector<std::uint8_t> units_of(std::span<const WorkBatch* const> batches) {
    std::array<bool, TextureUnits> used{};
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            used[unit.unit] = used[unit.unit] || !unit.accesses.empty();
    std::vector<std::uint8_t> units;
    for (std::uint8_t unit = 0; unit < TextureUnits; ++unit)
        if (used[unit]) units.push_back(unit);
    return units;
}

} // namespace

void CommandAssembler::draw(const WorkDraw& draw, std::span<const WorkBatch* const> batches) {
    auto whole = std::make_shared<WholeCommand>();
    whole->draw = draw;
    whole->units = units_of(batches);
    const auto sources = order_.of(batches, draw.kind == WorkKind::Image);
    whole->quads.resize(sources.size());
    WorkQuad* quad = whole->quads.data();
    for (const QuadSource& source : sources) {
        *quad = batches[source.batch]->quads[source.quad];
        quad++->piece = source.piece();
    }
    whole->access_begin.resize(sources.size() * whole->units.size() + 1);
    if (!whole->units.empty()) {
        index_.build(batches, whole->units);
        whole->accesses.resize(count_accesses(batches));
        copy_accesses(sources, *whole);
    }
    if (!sources.empty() && !batches[0]->value_begin.empty()) {
        whole->value_begin.push_back(0);
        for (const QuadSource& source : sources)
            append_values(*batches[source.batch], source.quad, *whole);
    }
    out_.command(std::move(whole));
}

// With lanes counted in the quad.
void CommandAssembler::copy_accesses(std::span<const QuadSource> sources,
                                     WholeCommand& whole) const {
    const std::size_t units = whole.units.size();
    TexelAccess* to = whole.accesses.data();
    std::uint32_t* begin = whole.access_begin.data() + 1;
    for (const QuadSource& source : sources)
        for (std::size_t unit = 0; unit < units; ++unit) {
            for (TexelAccess access : index_.of(source.batch, source.quad, unit)) {
                access.lane %= 4;
                *to++ = access;
            }
            *begin++ = static_cast<std::uint32_t>(to - whole.accesses.data());
        }
}

} // namespace ffgpu::work
