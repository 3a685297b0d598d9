// Long draws of the functional GPU: chunks of them go through geometry and set-up on all threads,
// each into bins of its own, while the bins before are drawn.

#include "model/base/check.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

namespace ffgpu {

// Where a chunk of a draw goes.
class FunctionalGpu::ChunkBins final : public BinSupply {
public:
    ChunkBins(FunctionalGpu& gpu, std::uint32_t draw)
        : gpu_(gpu)
        , draw_(draw) {}

    Bin& next_bin() override {
        Bin& bin = *bins_.emplace_back(gpu_.make_bin());
        bin.add_command({.kind = WorkKind::Draw,
                         .number = draw_,
                         .frame = gpu_.frame_,
                         .pixels = gpu_.context_->pixels});
        return bin;
    }

    void move_to(BinSequence& sequence) {
        for (auto& bin : bins_)
            sequence.bins.push_back(std::move(bin));
    }

private:
    FunctionalGpu& gpu_;
    std::uint32_t draw_;
    std::vector<std::unique_ptr<Bin>> bins_;
};

void FunctionalGpu::draw_in_chunks(const DrawCommand& command,
                                   std::uint32_t number,
                                   std::uint32_t chunks) {
    // Two for each thread even out what they take; their records stay in the caches. The last come
    // together, up to twice as many, so that there is more for others to draw while the caller goes
    // on.
    const std::uint32_t at_once = 2 * pool_.threads();
    geometry().begin_separate_chunks(context_->state, command);
    std::uint32_t count = 0;
    for (std::uint32_t first = 0; first < chunks; first += count) {
        count = chunks - first <= 2 * at_once ? chunks - first : at_once;
        finish_carrying();
        put_under_way();
        begin_command({.kind = WorkKind::Draw, .number = number});
        check(!under_way_.empty(), "bins that were not drawn are gone");
        std::deque<ChunkBins> filled;
        for (std::uint32_t i = 0; i < count; ++i)
            filled.emplace_back(*this, number);
        const std::size_t tiles = under_way_tiles_.size();
        pool_.run(filled.size() + tiles, [&](unsigned worker, std::size_t i) {
            if (i >= filled.size())
                return renderers_[worker]->render(
                    under_way_, under_way_tiles_[i - filled.size()], {});
            GeometryWorker& by = geometry_of(worker);
            by.binner.start(*context_, filled[i].next_bin(), filled[i], {});
            by.geometry.draw_chunk(
                context_->state, command, first + static_cast<std::uint32_t>(i), by.binner);
        });
        end_under_way();
        for (ChunkBins& bins : filled)
            bins.move_to(bins_);
    }
    for (const auto& worker : geometry_) {
        if (!worker || worker == geometry_[0]) continue;
        geometry().statistics().take_over(worker->geometry.statistics());
        primitive_statistics().take_over(worker->binner.statistics());
    }
    carry_out();
}

GeometryWorker& FunctionalGpu::geometry_of(unsigned worker) {
    auto& of_worker = geometry_[worker];
    if (!of_worker) of_worker = std::make_unique<GeometryWorker>(memory_.bytes(), *config_.stages);
    return *of_worker;
}

} // namespace ffgpu
