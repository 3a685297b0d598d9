// BinStock: bins that are not in use. Any thread that fills one takes it here.

#pragma once

#include "model/gpu/bin.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace ffgpu {

class BinStock {
public:
    // As Bin takes them.
    BinStock(int tile_size, std::size_t arena_bytes)
        : tile_size_(tile_size)
        , arena_bytes_(arena_bytes) {}

    std::unique_ptr<Bin> take() {
        const std::lock_guard lock(mutex_);
        if (bins_.empty()) return std::make_unique<Bin>(tile_size_, arena_bytes_);
        std::unique_ptr<Bin> bin = std::move(bins_.back());
        bins_.pop_back();
        return bin;
    }

    // What they hold is gone.
    void give_back(std::vector<std::unique_ptr<Bin>>& bins) {
        const std::lock_guard lock(mutex_);
        while (!bins.empty()) { // The first one is taken next.
            bins.back()->reset(0, 0);
            bins_.push_back(std::move(bins.back()));
            bins.pop_back();
        }
    }

private:
    const int tile_size_;
    const std::size_t arena_bytes_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Bin>> bins_;
};

} // namespace ffgpu
