// Moment: a cycle in which something was done, how much sooner that would have been without each
// resource, and what was waited for until then.
//
// A moment depends on others: all of them had to be over, and from each it takes some time to the
// next, some of it a resource's. The one that was over last decides; which one that is depends on
// the resources that there are. Without a resource a moment is as much sooner as the least of
// those that it depends on allows: what that one itself was sooner, what the resource takes between
// the two, and how long the moment did not wait for it as it was. What a moment waited for beyond
// all of them is waited for without any resource, too.

#pragma once

#include "model/timing/resource.h"
#include "model/timing/wait_paths.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace ffgpu::timing {

// Cycles by resource. Parts of a cycle are sixteenths or more: sums are exact below a million.
struct Saved {
    static constexpr std::size_t Lanes = (Resources + 3) / 4 * 4;
    alignas(16) std::array<float, Lanes> cycles{};

    float& operator[](Resource resource) { return cycles[static_cast<std::size_t>(resource)]; }
    float operator[](Resource resource) const { return cycles[static_cast<std::size_t>(resource)]; }
};

struct Moment {
    Cycle at = 0;
    WaitPaths::Path path = 0;
    Saved saved{};
};

struct Dependence {
    struct Part {
        Resource resource = Resource::Links;
        float cycles = 0;
    };
    const Moment* moment = nullptr;
    float takes = 0; // cycles from there at the least
    Part first{};    // what of them is saved without a resource; the wait's name in the path
    Part then{};     // and what without another, behind the first
};

// Of these, how long the moment did not wait for it.
inline float slack(const Dependence& dependence, Cycle at) {
    const auto since = static_cast<std::int64_t>(at - std::min(dependence.moment->at, at));
    return std::max(static_cast<float>(since) - dependence.takes, 0.0F);
}
// The dependence that was over last; of several the first.
const Dependence& last_of(std::span<const Dependence> all, Cycle at);
// `last`: last_of() them. By vectors; the plain form is what it must equal.
Saved saved_after(std::span<const Dependence> all, const Dependence& last, Cycle at);
Saved saved_after_plainly(std::span<const Dependence> all, const Dependence& last, Cycle at);
inline Saved saved_after(std::span<const Dependence> all, Cycle at) {
    return saved_after(all, last_of(all, at), at);
}

} // namespace ffgpu::timing
