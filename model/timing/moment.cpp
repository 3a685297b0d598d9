#include "model/timing/moment.h"

#include <algorithm>
#include <limits>

namespace ffgpu::timing {

float slack(const Dependence& dependence, Cycle at) {
    const Cycle from = std::min(dependence.moment->at, at);
    return std::max(static_cast<float>(at - from) - dependence.takes, 0.0F);
}

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

Saved saved_after(std::span<const Dependence> all, const Dependence& last, Cycle at) {
    const float least = slack(last, at);
    Saved saved;
    saved.cycles.fill(std::numeric_limits<float>::max());
    for (const Dependence& each : all) {
        Saved one = each.moment->saved;
        one[each.first.resource] += each.first.cycles;
        one[each.then.resource] += each.then.cycles;
        const float more = slack(each, at) - least;
        for (std::size_t i = 0; i < Saved::Lanes; ++i)
            saved.cycles[i] = std::min(saved.cycles[i], one.cycles[i] + more);
    }
    return saved;
}

} // namespace ffgpu::timing
