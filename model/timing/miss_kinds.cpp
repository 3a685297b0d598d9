#include "model/timing/miss_kinds.h"

namespace ffgpu::timing {

using work::MissKind;

// Out of line, or each look-up saves registers for it.
[[gnu::noinline]] void MissKinds::settle() {
    for (const Entry& entry : log_)
        reckon(entry);
    log_.clear();
}

inline MissKind MissKinds::access(const Entry& entry) {
    return keeps_recent_ ? classifier_.access_first(entry.line, entry.place)
                         : classifier_.access(entry.line);
}

inline void MissKinds::reckon(const Entry& entry) {
    switch (entry.what) {
    case Hit:
        access(entry);
        if (classifier_.shadow_missed()) ++statistics_.beyond_shadow;
        break;
    case Miss:
        count(access(entry));
        break;
    case Drop:
        classifier_.drop(entry.line);
        break;
    case Flush:
        classifier_.flush();
        break;
    }
}

} // namespace ffgpu::timing
