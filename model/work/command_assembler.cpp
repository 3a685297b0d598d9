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

std::vector<std::uint8_t> units_of(std::span<const WorkBatch* const> batches) {
    std::array<bool, TextureUnits> used{};
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            used[unit.unit] = used[unit.unit] || !unit.empty();
    std::vector<std::uint8_t> units;
    for (std::uint8_t unit = 0; unit < TextureUnits; ++unit)
        if (used[unit]) units.push_back(unit);
    return units;
}

void add_footprints(std::span<const WorkBatch* const> batches, WholeCommand& whole) {
    const std::size_t units = whole.units.size();
    std::array<std::size_t, TextureUnits> place{};
    for (std::size_t i = 0; i < units; ++i)
        place[whole.units[i]] = i;
    whole.footprints.resize(batches.size() * units);
    const TexelFootprints** of_batch = whole.footprints.data();
    for (const WorkBatch* const batch : batches) {
        for (const TexelFootprints& unit : batch->textures)
            if (!unit.empty()) of_batch[place[unit.unit]] = &unit;
        of_batch += units;
    }
}

} // namespace

void CommandAssembler::draw_part(const WorkDraw& draw, const DrawPart& part) {
    bins_.push_back(part.bin);
    batches_.insert(batches_.end(), part.batches.begin(), part.batches.end());
    if (!part.last) return;
    const auto bins = std::exchange(bins_, {});
    const auto batches = std::exchange(batches_, {});
    auto whole = std::make_shared<WholeCommand>();
    whole->draw = draw;
    whole->units = units_of(batches);
    const auto sources = order_.of(batches, draw.kind == WorkKind::Image);
    whole->quads.reserve(sources.size());
    for (const QuadSource& source : sources)
        whole->quads.push_back(batches[source.batch]->quads[source.quad]);
    if (draw.kind == WorkKind::Image)
        for (std::size_t i = 0; i < sources.size(); ++i)
            whole->quads[i].piece = sources[i].piece();
    if (!whole->units.empty()) {
        whole->bins = bins;
        add_footprints(batches, *whole);
        whole->sources.reserve(sources.size());
        for (const QuadSource& source : sources)
            whole->sources.push_back({source.batch, source.quad});
    }
    if (!sources.empty() && !batches[0]->value_begin.empty()) {
        whole->value_begin.push_back(0);
        for (const QuadSource& source : sources)
            append_values(*batches[source.batch], source.quad, *whole);
    }
    out_.command(std::move(whole));
}

} // namespace ffgpu::work
