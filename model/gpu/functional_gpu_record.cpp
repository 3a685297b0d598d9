// The functional GPU's bins as the work stream tells them.

#include "model/base/float_environment.h"
#include "model/gpu/functional_gpu.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ffgpu {

// Bins that others listen to, or that one thread has to draw (`alone`).
void FunctionalGpu::draw_and_record(bool alone) {
    const FloatEnvironment environment;
    const std::vector<std::uint32_t>& tiles = under_way_tiles_;
    std::vector<std::shared_ptr<ChunkMemory>> memory(sink_ ? renderers_.size() : 0);
    for (auto& of_worker : memory)
        of_worker = std::make_shared<ChunkMemory>(record_chunks_);
    std::vector<WorkTile> recordings(sink_ ? tiles.size() : 0);
    const auto job = [&](unsigned worker, std::size_t i) {
        TileRenderer::Recording recording;
        if (sink_) recording = {&recordings[i], memory[worker].get()};
        renderers_[worker]->render(under_way_, tiles[i], recording);
    };
    if (alone) {
        for (std::size_t i = 0; i < tiles.size(); ++i)
            job(0, i);
    } else {
        pool_.run(tiles.size(), job);
    }
    if (sink_) hand_over(std::move(recordings), std::move(memory));
}

void FunctionalGpu::hand_over(std::vector<WorkTile> tiles,
                              std::vector<std::shared_ptr<ChunkMemory>> memory) {
    auto work = std::make_shared<WorkBin>();
    work->memory = std::move(memory);
    for (const auto& bin : under_way_.bins) {
        for (BinCommand& command : bin->commands())
            work->draws.push_back({.kind = command.kind,
                                   .number = command.number,
                                   .frame = command.frame,
                                   .early_depth = command.pixels->pipe.early_depth,
                                   .register_writes = command.register_writes,
                                   .register_words = command.register_words,
                                   .state = command.context->state.registers,
                                   .geometry = std::move(command.geometry),
                                   .image = command.image ? *command.image : DrawImageCommand{},
                                   .clear = command.clear});
    }
    std::erase_if(tiles, [](const WorkTile& tile) { return tile.batches.empty(); });
    work->tiles = std::move(tiles);
    work->transfers = std::exchange(transfers_, {});
    work->contents = std::exchange(contents_, {});
    work->last_draw_goes_on = draw_goes_on_;
    sink_->bin(std::move(work));
}

} // namespace ffgpu
