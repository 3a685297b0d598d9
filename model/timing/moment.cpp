#include "model/timing/moment.h"

namespace ffgpu::timing {

Saved saved_after_plainly(const Dependences& all) {
    Saved saved;
    saved.cycles.fill(std::numeric_limits<float>::max());
    for (std::size_t place = 0; place < all.count(); ++place) {
        const Dependence& each = all[place];
        Saved before = each.moment->saved;
        before[each.first.resource] += each.first.cycles;
        before[each.then.resource] += each.then.cycles;
        const float more = slack(each, all.at()) - all.least();
        for (std::size_t i = 0; i < Saved::Lanes; ++i)
            saved.cycles[i] = std::min(saved.cycles[i], before.cycles[i] + more);
    }
    return saved;
}

} // namespace ffgpu::timing
