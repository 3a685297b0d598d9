// MachineThread: runs the machine on a thread of its own, so that the work of the next draws is
// made ready while it runs. What the machine reads and when its time stands still do not depend on
// it (clock.h).

#pragma once

#include "model/timing/machine.h"
#include "model/work/job_thread.h"

#include <functional>

namespace ffgpu::timing {

class MachineThread final : public work::MachineSink {
public:
    explicit MachineThread(Machine& machine);

    void scene(work::PreparedScene&& scene) override;
    void part(work::PreparedPart&& part) override;
    bool takes_parts() const override { return machine_.takes_parts(); }
    void end_commands() override;
    void transfer(work::PreparedTransfer&& transfer) override;
    void host_transfer(const HostTransfer& transfer) override;
    // Returns when the frame has ended; with overlapping frames at once, and throws what went
    // wrong.
    void end_frame(std::uint32_t frame) override;
    void let_frames_overlap() { frames_overlap_ = true; }
    void content(work::PreparedContent&& content) override;
    void host_access(std::vector<work::TransferLine>&& lines) override;
    void texels_rewritten(std::vector<std::uint64_t>&& lines) override;
    void show(const work::PlacedLevel& picture);

    // Calls it when the machine has read all that it was given before.
    void post(std::function<void()> job);
    // Returns when the machine has read all that it was given.
    void catch_up();

private:
    Machine& machine_;
    bool frames_overlap_ = false;
    work::JobThread jobs_; // The last: its thread uses the machine.
};

} // namespace ffgpu::timing
