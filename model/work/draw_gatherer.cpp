#include "model/work/draw_gatherer.h"

#include "model/base/check.h"

#include <utility>

namespace ffgpu::work {

void DrawGatherer::bin(std::shared_ptr<const WorkBin> bin) {
    std::vector<DrawParts> parts(bin->draws.size());
    if (!begun_.bins.empty()) {
        check(!parts.empty(), "a bin that goes on with a draw holds the draw");
        parts[0] = std::exchange(begun_, {});
    }
    for (const WorkTile& tile : bin->tiles)
        for (const WorkBatch& batch : tile.batches)
            parts[batch.draw].batches.push_back(&batch);
    auto transfer = bin->transfers.begin();
    const auto transfers_before = [&](std::size_t draw) {
        for (; transfer != bin->transfers.end() && transfer->before_draw <= draw; ++transfer)
            out_.host_transfer(*transfer);
    };
    auto content = bin->contents.begin();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        transfers_before(i);
        for (; content != bin->contents.end() && (*content)->before_draw <= i; ++content)
            out_.content(*content);
        parts[i].bins.push_back(bin);
        if (bin->last_draw_goes_on && i + 1 == parts.size()) {
            begun_ = std::move(parts[i]);
            return;
        }
        out_.draw(bin->draws[i], parts[i]);
        parts[i] = {};
    }
    transfers_before(parts.size());
}

} // namespace ffgpu::work
