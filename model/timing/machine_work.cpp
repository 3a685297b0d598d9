// What the machine is told: work, which waits for its host's bus until there is enough of it to
// run.

#include "model/base/check.h"
#include "model/timing/machine.h"

#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::size_t MostWaiting = 1 << 11; // quads: then they are run

} // namespace

void Machine::scene(work::PreparedScene&& scene) {
    waiting_quads += scene.quads.size() + scene.draws.size();
    scenes.emplace_back(std::move(scene), ledger);
    scenes.back().number = scenes_told++;
    scenes.back().host_writes = std::exchange(host_writes, {});
    host.enqueue(scenes.back());
    if (scenes.back().waits_for_quads()) scenes_without_quads.push_back(&scenes.back());
    if (waiting_quads >= MostWaiting) run();
}

void Machine::part(work::PreparedPart&& part) {
    check(!scenes_without_quads.empty(), "a part is of a scene that waits for quads");
    waiting_quads += part.quads.size();
    TimedScene& scene = *scenes_without_quads.front();
    scene.add(std::move(part));
    if (!scene.waits_for_quads()) scenes_without_quads.pop_front();
    if (waiting_quads >= MostWaiting) run();
}

void Machine::transfer(work::PreparedTransfer&& transfer) {
    host.enqueue(std::move(transfer));
    if (++waiting_quads >= MostWaiting) run();
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
    if (++waiting_quads >= MostWaiting) run();
}

void Machine::end_commands() {
    host.enqueue_frame_end();
    commands_ended = true;
}

void Machine::end_frame(std::uint32_t number) {
    if (!std::exchange(commands_ended, false)) host.enqueue_frame_end();
    run();
    finish_frame(number);
}

void Machine::show(const work::PlacedLevel& picture) {
    scan_out.show(picture.base, picture.layer_bytes);
}

} // namespace ffgpu::timing
