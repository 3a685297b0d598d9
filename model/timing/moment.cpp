#include "model/timing/moment.h"

#include <algorithm>
#include <limits>

namespace ffgpu::timing {

const Dependence& last_of(std::span<const Dependence> all, Cycle at) {
    const Dependence* last = &all[0];
    float least = slack(*last, at);
    for (const Dependence& each : all.subspan(1)) {
        const float waited = slack(each, at);
        if (waited >= least) continue;
        least = waited;
        last = &each;
    }
    return *last;
}

Saved saved_after_plainly(std::span<const Dependence> all, const Dependence& last, Cycle at) {
    const float least = slack(last, at);
    Saved saved;
    saved.cycles.fill(std::numeric_limits<float>::max());
    for (const Dependence& each : all) {
        Saved before = each.moment->saved;
        before[each.first.resource] += each.first.cycles;
        before[each.then.resource] += each.then.cycles;
        const float more = slack(each, at) - least;
        for (std::size_t i = 0; i < Saved::Lanes; ++i)
            saved.cycles[i] = std::min(saved.cycles[i], before.cycles[i] + more);
    }
    return saved;
}

} // namespace ffgpu::timing
