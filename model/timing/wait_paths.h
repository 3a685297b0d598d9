// WaitPaths: paths through time, each told by what was waited for, cycle after cycle. Paths share
// the past that they have in common.

#pragma once

#include "model/timing/clock.h"
#include "model/timing/resource.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::timing {

class WaitPaths {
public:
    using Path = std::uint32_t;

    // `most`: nodes before it looks which of them are of use.
    explicit WaitPaths(std::size_t most = 1 << 16)
        : most_(most) {}

    // Cycles up to and including `end`, since the run before it.
    struct Run {
        Cycle end = 0;
        Resource resource = Resource::Links;
    };

    // The path of a frame that begins after cycle `now`; all others are forgotten.
    Path restart(Cycle now);

    // Who goes a way of its own from here says so before it is made longer.
    Path share(Path path) {
        nodes_[path].shared = true;
        return path;
    }
    // On to cycle `end`, by waiting for `resource`. A path that was shared stays as it is.
    Path extend(Path path, Resource resource, Cycle end) {
        Node& last = nodes_[path];
        if (end <= last.end) return path;
        const bool goes_on = last.resource == resource && path != 0;
        if (!goes_on || last.shared) return add({end, goes_on ? last.before : path, resource});
        last.end = end;
        return path;
    }

    Cycle end(Path path) const { return nodes_[path].end; }
    // From the frame's begin.
    std::vector<Run> runs(Path path) const;

    std::size_t nodes() const { return nodes_.size(); }
    // It is time to collect: nodes are many.
    bool is_full() const { return nodes_.size() >= most_; }
    // Forgets the paths that none of `kept` goes through; names these anew.
    void collect(std::span<Path* const> kept);

private:
    // A run, in 16 bytes.
    struct Node {
        Cycle end = 0;
        Path before = 0; // the first: itself
        Resource resource = Resource::Links;
        bool shared = false;
    };

    Path add(const Node& node) {
        nodes_.push_back(node);
        return static_cast<Path>(nodes_.size() - 1);
    }

    std::vector<Node> nodes_;
    std::vector<Path> moved_; // while it collects
    std::size_t most_;
};

} // namespace ffgpu::timing
