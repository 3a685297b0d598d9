// TargetBlocks: the states of the targets' blocks and their coarse depths, as the configuration
// wants them. What it does not want is null.

#pragma once

#include "model/timing/block_states.h"
#include "model/timing/config.h"
#include "model/timing/hierarchical_depth.h"

#include <memory>
#include <vector>

namespace ffgpu::timing {

struct TargetBlocks {
    explicit TargetBlocks(const TimingConfig& config);

    std::vector<const StatisticsGroup*> statistics() const;

    std::unique_ptr<HierarchicalDepth> coarse;
    std::unique_ptr<BlockStates> depth, color;
};

// Throws InputError: what is configured does not go together.
void check_blocks(const TimingConfig& config);

// Throws InputError: `config` needs values that the work does not tell. `contents_told`: of a
// target before the command; work with values does before the first one that draws or clears.
void check_values(const TimingConfig& config,
                  const work::WholeCommand& command,
                  bool contents_told);

} // namespace ffgpu::timing
