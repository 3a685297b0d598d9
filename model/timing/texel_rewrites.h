// TexelRewrites: lines of the texel cache whose texels changed, on their way to the texture units:
// before the quads of which scene.

#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class TexelRewrites {
public:
    // `scene`: the number of the next one.
    void add(std::uint64_t scene, std::vector<std::uint64_t>&& lines) {
        waiting_.push_back({scene, std::move(lines)});
    }

    // Some are before the quads of the scene, and were not taken.
    bool come_before(std::uint64_t scene) const {
        return !waiting_.empty() && waiting_.front().scene <= scene;
    }

    // The lines that changed first of all, in rising order.
    std::vector<std::uint64_t> take() {
        std::vector<std::uint64_t> lines = std::move(waiting_.front().lines);
        waiting_.pop_front();
        return lines;
    }

private:
    struct Rewrite {
        std::uint64_t scene = 0;
        std::vector<std::uint64_t> lines;
    };

    std::deque<Rewrite> waiting_;
};

} // namespace ffgpu::timing
