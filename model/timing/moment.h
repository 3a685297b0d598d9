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

#include "model/base/check.h"
#include "model/timing/resource.h"
#include "model/timing/wait_paths.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace ffgpu::timing {

// Of machines that gather scenes, or interpolate, alone.
constexpr bool is_rare(Resource resource) {
    return resource == Resource::Binner || resource == Resource::ParameterFetch ||
           resource == Resource::TileMemory || resource == Resource::Interpolator;
}

// Cycles by resource. Parts of a cycle are sixteenths or more: sums are exact below a million. Rare
// resources come behind the first lanes, which are all that other machines use.
struct Saved {
    static constexpr std::size_t FirstLanes = 16, Lanes = (Resources + 3) / 4 * 4;
    alignas(16) std::array<float, Lanes> cycles{};

    static constexpr std::size_t lane(Resource resource);
    float& operator[](Resource resource) { return cycles[lane(resource)]; }
    float operator[](Resource resource) const { return cycles[lane(resource)]; }
};

inline constexpr std::array<std::uint8_t, Resources> LaneOf = [] {
    std::array<std::uint8_t, Resources> lanes{};
    std::uint8_t first = 0, rare = Saved::FirstLanes;
    for (std::size_t i = 0; i < Resources; ++i)
        lanes[i] = is_rare(static_cast<Resource>(i)) ? rare++ : first++;
    return lanes;
}();
constexpr std::size_t Saved::lane(Resource resource) {
    return LaneOf[static_cast<std::size_t>(resource)];
}

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

// How long a moment in that cycle did not wait for it. What lies ahead was not waited for.
inline float slack(const Dependence& dependence, Cycle at) {
    const auto since = static_cast<std::int64_t>(at - dependence.moment->at);
    return std::max(static_cast<float>(since) - dependence.takes, 0.0F);
}

class Dependences;
using SavedAfter = void (*)(const Dependences& all, Saved& result);
// Dependences::save() by the processor's vectors: asked for once.
SavedAfter saved_after_by_vectors();

// Those of a moment in one cycle.
class Dependences {
public:
    // Who adds them sees to it that there are no more.
    static constexpr std::size_t Most = 64;

    Dependences() = default;
    Dependences(const Dependences&) = delete; // It points into itself.
    Dependences& operator=(const Dependences&) = delete;

    // No moment that comes saves anything in the rare lanes.
    void leave_out_rare() { has_rare_ = false; }
    bool has_rare() const { return has_rare_; }

    // Those of another moment.
    void begin(Cycle at) {
        at_ = at;
        end_ = all_.data();
        last_ = all_.data();
        least_ = std::numeric_limits<float>::max();
    }
    // Inlined, as what the caller puts together would have to wait, part by part, to be read as a
    // whole.
    [[gnu::always_inline]] void add(const Dependence& one) {
        Found& found = *end_++;
        static_cast<Dependence&>(found) = one;
        found.slack = slack(one, at_);
        last_ = found.slack < least_ ? &found : last_;
        least_ = std::min(found.slack, least_);
    }
    // It takes more than was known.
    void lengthen(std::size_t place, float cycles) {
        all_[place].takes += cycles;
        all_[place].slack = slack(all_[place], at_);
        last_ = std::min_element(
            all_.data(), end_, [](const Found& a, const Found& b) { return a.slack < b.slack; });
        least_ = last_->slack;
    }

    Cycle at() const { return at_; }
    std::size_t count() const { return static_cast<std::size_t>(end_ - all_.data()); }
    const Dependence& operator[](std::size_t place) const { return all_[place]; }
    Dependence& operator[](std::size_t place) { return all_[place]; }
    float slack_of(std::size_t place) const { return all_[place].slack; }
    // The one that was over last; of several the first. There is one.
    std::size_t last() const { return static_cast<std::size_t>(last_ - all_.data()); }
    const Dependence& last_one() const { return *last_; }
    // The moment did not wait for that so long.
    float least() const { return least_; }
    // How much sooner the moment is; it may be of one of theirs.
    void save(Saved& result) const { by_vectors_(*this, result); }

private:
    struct Found : Dependence {
        float slack;
    };
    static_assert(sizeof(Found) == 32, "as many bytes as the dependence itself");

    std::array<Found, Most> all_;
    Found* end_ = all_.data();
    Found* last_ = all_.data();
    float least_ = 0;
    Cycle at_ = 0;
    bool has_rare_ = true;
    const SavedAfter by_vectors_ = saved_after_by_vectors();
};

// How much sooner a moment is that depends on these. By vectors rare lanes are left as they are
// where there are none; this form is what these must equal.
Saved saved_after_plainly(const Dependences& all);

} // namespace ffgpu::timing
