#include "model/work/draw_splitter.h"

#include "model/base/check.h"

namespace ffgpu::work {

void DrawSplitter::bin(std::shared_ptr<const WorkBin> bin) {
    check(!goes_on_ || !bin->draws.empty(), "a bin that goes on with a draw holds the draw");
    std::vector<DrawPart> parts(bin->draws.size());
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
        goes_on_ = bin->last_draw_goes_on && i + 1 == parts.size();
        parts[i].bin = bin;
        parts[i].last = !goes_on_;
        out_.draw_part(bin->draws[i], parts[i]);
        parts[i] = {};
    }
    if (!goes_on_) transfers_before(parts.size());
}

} // namespace ffgpu::work
