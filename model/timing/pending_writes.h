// PendingWrites: quads on their way to the late depth test that may write there. A quad that is
// tested early waits for those at its own place; a line's coarse depths are not narrowed while
// there are any in it.

#pragma once

#include "model/base/check.h"

#include <cstdint>
#include <unordered_map>

namespace ffgpu::timing {

class PendingWrites {
public:
    // A quad's place: the target and the pixel.
    static std::uint64_t place(std::uint64_t base, std::uint16_t x, std::uint16_t y) {
        return base << 26 | std::uint64_t{y / 2u} << 13 | x / 2u;
    }

    void add(std::uint64_t key) { ++count_[key]; }
    void done(std::uint64_t key) {
        const auto found = count_.find(key);
        check(found != count_.end(), "a late write that nobody announced");
        if (--found->second == 0) count_.erase(found);
    }
    bool any(std::uint64_t key) const { return count_.find(key) != count_.end(); }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> count_;
};

} // namespace ffgpu::timing
