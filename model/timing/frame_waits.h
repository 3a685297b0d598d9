// FrameWaits: what a frame waited for, and would have saved without each resource.

#pragma once

#include "model/timing/moment.h"
#include "model/timing/wait_paths.h"

#include <vector>

namespace ffgpu::timing {

struct FrameWaits {
    std::vector<WaitPaths::Run> runs{}; // its path; none where nobody looked
    Saved saved{};
    std::vector<Saved> saved_by{}; // of that, by the ledger's entries
    Saved saved_at_end{};          // the rest, of the frame's end
};

} // namespace ffgpu::timing
