#include "model/timing/machine_thread.h"

#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::size_t MostWeight = 1 << 17; // quads and lines that wait

} // namespace

MachineThread::MachineThread(Machine& machine)
    : machine_(machine)
    , jobs_(MostWeight) {}

void MachineThread::scene(work::PreparedScene&& scene) {
    const std::size_t weight = 1 + scene.draws.size() + scene.quads.size();
    jobs_.push(weight,
               [this, scene = std::move(scene)]() mutable { machine_.scene(std::move(scene)); });
}

void MachineThread::part(work::PreparedPart&& part) {
    const std::size_t weight = part.quads.size();
    jobs_.push(weight,
               [this, part = std::move(part)]() mutable { machine_.part(std::move(part)); });
}

void MachineThread::transfer(work::PreparedTransfer&& transfer) {
    const std::size_t weight = 1 + transfer.lines.size();
    jobs_.push(weight, [this, transfer = std::move(transfer)]() mutable {
        machine_.transfer(std::move(transfer));
    });
}

void MachineThread::host_transfer(const HostTransfer& transfer) {
    jobs_.push(1, [this, transfer] { machine_.host_transfer(transfer); });
}

void MachineThread::end_commands() {
    jobs_.push(1, [this] { machine_.end_commands(); });
}

void MachineThread::end_frame(std::uint32_t frame) {
    jobs_.push(1, [this, frame] { machine_.end_frame(frame); });
    frames_overlap_ ? jobs_.check_failure() : jobs_.drain();
}

void MachineThread::content(work::PreparedContent&& content) {
    jobs_.push(1, [this, content = std::move(content)]() mutable {
        machine_.content(std::move(content));
    });
}

void MachineThread::host_access(std::vector<work::TransferLine>&& lines) {
    const std::size_t weight = 1 + lines.size();
    jobs_.push(weight, [this, lines = std::move(lines)]() mutable {
        machine_.host_access(std::move(lines));
    });
}

void MachineThread::texels_rewritten(std::vector<std::uint64_t>&& lines) {
    const std::size_t weight = 1 + lines.size();
    jobs_.push(weight, [this, lines = std::move(lines)]() mutable {
        machine_.texels_rewritten(std::move(lines));
    });
}

void MachineThread::show(const work::PlacedLevel& picture) {
    jobs_.push(1, [this, picture] { machine_.show(picture); });
}

void MachineThread::post(std::function<void()> job) {
    jobs_.push(1, [this, job = std::move(job)] {
        machine_.run();
        job();
    });
}

void MachineThread::catch_up() {
    post([] {});
    jobs_.drain();
}

} // namespace ffgpu::timing
