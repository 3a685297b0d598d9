// Link: what a channel of any type tells the units at its ends, so that they need not look in every
// cycle.

#pragma once

#include "model/timing/clock.h"

namespace ffgpu::timing {

class Unit;

class Link {
public:
    // When the oldest item can be popped; Never where there is none.
    Cycle arrival() const { return arrival_; }

protected:
    Cycle arrival_ = Never;
};

} // namespace ffgpu::timing
