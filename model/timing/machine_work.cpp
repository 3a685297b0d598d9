// What the machine is told: work, which waits for its host's bus until there is enough of it to
// run.

#include "model/timing/machine.h"

#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::size_t MostWaiting = 1 << 11; // quads that are taken before they are run

} // namespace

void Machine::scene(work::PreparedScene&& scene) {
    waiting_quads += scene.quads.size() + scene.draws.size();
    scenes.emplace_back(std::move(scene), ledger);
    scenes.back().number = scenes_told++;
    scenes.back().host_writes = std::exchange(host_writes, {});
    host.enqueue(scenes.back());
    if (waiting_quads > MostWaiting) run();
}

void Machine::transfer(work::PreparedTransfer&& transfer) {
    host.enqueue(std::move(transfer));
    if (++waiting_quads > MostWaiting) run();
}

void Machine::content(work::PreparedContent&& content) {
    if (content.depth ? blocks.depth : blocks.color) host.enqueue(std::move(content));
}

void Machine::host_access(std::vector<work::TransferLine>&& lines) {
    if (blocks.depth || blocks.color) host.enqueue(std::move(lines));
}

void Machine::texels_rewritten(std::vector<std::uint64_t>&& lines) {
    rewrites.add(scenes_told, std::move(lines));
}

void Machine::host_transfer(const HostTransfer& transfer) {
    host.enqueue(transfer);
    if (transfer.is_write) host_writes.push_back({transfer.at, transfer.at + transfer.bytes});
    if (++waiting_quads > MostWaiting) run();
}

void Machine::end_frame(std::uint32_t number) {
    host.enqueue_frame_end();
    run();
    finish_frame(number);
}

void Machine::show(const work::PlacedLevel& picture) {
    scan_out.show(picture.base, picture.layer_bytes);
}

} // namespace ffgpu::timing
