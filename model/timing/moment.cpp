#include "model/timing/moment.h"

#include <algorithm>
#include <limits>

namespace ffgpu::timing {
namespace {

using PartLanes = std::array<float, Saved::Lanes>;

// A one in the lane of each resource.
constexpr std::array<PartLanes, Resources> parts_of_resources() {
    std::array<PartLanes, Resources> parts{};
    for (std::size_t i = 0; i < Resources; ++i)
        parts[i][i] = 1;
    return parts;
}

alignas(16) constexpr std::array<PartLanes, Resources> PartsOf = parts_of_resources();

} // namespace

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

// Parts are added to all lanes, as nothing where they are not the lane's own: a lane that is
// written and then read in a vector would be waited for.
Saved saved_after(std::span<const Dependence> all, const Dependence& last, Cycle at) {
    const float least = slack(last, at);
    Saved saved;
    saved.cycles.fill(std::numeric_limits<float>::max());
    for (const Dependence& each : all) {
        const float more = slack(each, at) - least;
        const PartLanes& first = PartsOf[static_cast<std::size_t>(each.first.resource)];
        const PartLanes& then = PartsOf[static_cast<std::size_t>(each.then.resource)];
        const Saved before = each.moment->saved;
        for (std::size_t i = 0; i < Saved::Lanes; ++i) {
            const float with_first = before.cycles[i] + first[i] * each.first.cycles;
            const float with_both = with_first + then[i] * each.then.cycles;
            saved.cycles[i] = std::min(saved.cycles[i], with_both + more);
        }
    }
    return saved;
}

} // namespace ffgpu::timing
