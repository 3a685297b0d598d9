#include "model/work/access_index.h"

#include <algorithm>

namespace ffgpu::work {

void AccessIndex::build(std::span<const WorkBatch* const> batches,
                        std::span<const std::uint8_t> units) {
    units_ = units.size();
    batches_.assign(batches.size() * units_, {});
    ends_.clear();
    Unit* of_batch = batches_.data();
    for (const WorkBatch* const batch : batches) {
        for (const TexelFootprints& footprints : batch->textures) {
            const auto unit = std::find(units.begin(), units.end(), footprints.unit);
            if (unit != units.end() && !footprints.accesses.empty())
                add(*batch, footprints.accesses, of_batch[unit - units.begin()]);
        }
        of_batch += units_;
    }
}

// Accesses are in the order of lanes, and a quad without any ends where the one before does.
void AccessIndex::add(const WorkBatch& batch,
                      const std::vector<TexelAccess>& accesses,
                      Unit& unit) {
    unit = {accesses.data(), ends_.size()};
    ends_.resize(ends_.size() + batch.quads.size() + 1, 0);
    std::uint32_t* const ends = ends_.data() + unit.first_end;
    std::uint32_t count = 0;
    for (const TexelAccess& access : accesses)
        ends[access.lane / 4 + 1] = ++count;
    for (std::size_t quad = 0; quad < batch.quads.size(); ++quad)
        ends[quad + 1] = std::max(ends[quad], ends[quad + 1]);
}

} // namespace ffgpu::work
