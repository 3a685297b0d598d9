#include "model/work/command_assembler.h"

#include <algorithm>
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

std::size_t words_of_accesses(std::span<const WorkBatch* const> batches) {
    std::size_t words = 0;
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            words += unit.accesses.words();
    return words;
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
    if (!whole->units.empty()) copy_accesses(batches, sources, *whole);
    if (!sources.empty() && !batches[0]->value_begin.empty()) {
        whole->value_begin.push_back(0);
        for (const QuadSource& source : sources)
            append_values(*batches[source.batch], source.quad, *whole);
    }
    out_.command(std::move(whole));
}

void CommandAssembler::copy_accesses(std::span<const WorkBatch* const> batches,
                                     std::span<const QuadSource> sources,
                                     WholeCommand& whole) {
    static const TexelAccesses none;
    const std::size_t units = whole.units.size();
    in_batches_.assign(batches.size() * units, &none);
    for (std::size_t batch = 0; batch < batches.size(); ++batch)
        for (const TexelFootprints& of : batches[batch]->textures) {
            const auto unit = std::find(whole.units.begin(), whole.units.end(), of.unit);
            if (unit == whole.units.end()) continue;
            const auto number = static_cast<std::size_t>(unit - whole.units.begin());
            in_batches_[batch * units + number] = &of.accesses;
        }
    whole.accesses.make_room(sources.size() * units, words_of_accesses(batches));
    for (const QuadSource& source : sources)
        for (std::size_t unit = 0; unit < units; ++unit)
            whole.accesses.add(in_batches_[source.batch * units + unit]->of(source.quad));
}

} // namespace ffgpu::work
