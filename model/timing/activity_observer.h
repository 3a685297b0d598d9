// ActivityObserver: is told when what a unit does changes. It never changes a cycle.

#pragma once

#include "model/timing/account.h"

#include <cstddef>

namespace ffgpu::timing {

class ActivityObserver {
public:
    virtual ~ActivityObserver() = default;
    // From cycle `first` on the unit is at `activity`; in the order of the cycles. Before its first
    // change a unit is idle.
    virtual void changed(std::size_t unit, Activity activity, Cycle first) = 0;
};

} // namespace ffgpu::timing
