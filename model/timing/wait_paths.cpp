#include "model/timing/wait_paths.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

WaitPaths::Path WaitPaths::restart(Cycle now) {
    nodes_.assign(1, {now, 0, Resource::Links, true});
    return 0;
}

std::vector<WaitPaths::Run> WaitPaths::runs(Path path) const {
    std::vector<Run> runs;
    for (; path != 0; path = nodes_[path].before)
        runs.push_back({nodes_[path].end, nodes_[path].resource});
    std::reverse(runs.begin(), runs.end());
    return runs;
}

// A path's nodes stand behind the one before them: what is marked from the last to the first is
// moved from the first to the last.
void WaitPaths::collect(std::span<Path* const> kept) {
    std::vector<Path>& moved = moved_;
    moved.assign(nodes_.size(), 0);
    moved[0] = 1;
    for (const Path* const path : kept)
        moved[*path] = 1;
    for (std::size_t i = nodes_.size(); i-- > 0;)
        if (moved[i] != 0) moved[nodes_[i].before] = 1;
    Path count = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (moved[i] == 0) continue;
        Node node = nodes_[i];
        node.before = moved[node.before];
        if (i == 0) node.before = 0;
        moved[i] = count;
        nodes_[count++] = node;
    }
    nodes_.resize(count);
    for (Path* const path : kept)
        *path = moved[*path];
    most_ = std::max<std::size_t>(most_, 2 * std::size_t{count});
}

} // namespace ffgpu::timing
