#include "model/timing/miss_kinds.h"

namespace ffgpu::timing {

using work::MissKind;

// Out of line, or each look-up saves registers for it.
[[gnu::noinline]] void MissKinds::settle() {
    for (const std::uint64_t entry : log_)
        reckon(entry);
    log_.clear();
}

inline void MissKinds::reckon(std::uint64_t entry) {
    const std::uint64_t line = entry & ((std::uint64_t{1} << WhatAt) - 1);
    switch (static_cast<What>(entry >> WhatAt)) {
    case Hit:
        classifier_.access(line);
        if (classifier_.shadow_missed()) ++statistics_.beyond_shadow;
        break;
    case Miss:
        count(classifier_.access(line));
        break;
    case Drop:
        classifier_.drop(line);
        break;
    case Flush:
        classifier_.flush();
        break;
    }
}

inline void MissKinds::count(MissKind kind) {
    ++(kind == MissKind::Compulsory ? statistics_.compulsory
       : kind == MissKind::Capacity ? statistics_.capacity
                                    : statistics_.conflict);
}

} // namespace ffgpu::timing
