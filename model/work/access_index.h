// AccessIndex: where the accesses of each quad are in a draw's batches. It keeps its memory from
// draw to draw.

#pragma once

#include "model/packets/work_stream.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

class AccessIndex {
public:
    // Of the accesses in `units`, which rise. Valid as long as the batches are.
    void build(std::span<const WorkBatch* const> batches, std::span<const std::uint8_t> units);

    // Of the batch's quad in units[unit]: lanes are the batch's.
    std::span<const TexelAccess> of(std::size_t batch, std::size_t quad, std::size_t unit) const {
        const Unit& where = batches_[batch * units_ + unit];
        if (!where.accesses) return {};
        const std::uint32_t* const end = ends_.data() + where.first_end + quad;
        return {where.accesses + end[0], where.accesses + end[1]};
    }

private:
    struct Unit {
        const TexelAccess* accesses = nullptr; // null: none
        std::size_t first_end = 0; // in ends_: 0, then behind the accesses of quad 0, of 1 ...
    };
    void add(const WorkBatch& batch, const std::vector<TexelAccess>& accesses, Unit& unit);

    std::size_t units_ = 0;
    std::vector<Unit> batches_; // of each batch all units
    std::vector<std::uint32_t> ends_;
};

} // namespace ffgpu::work
