// What the blocks of the depth or the colour targets saved and cost.

#pragma once

#include "model/base/statistics.h"

#include <deque>
#include <string>

namespace ffgpu::timing {

// Names carry the cache's: depth_blocks_cleared ...
class BlockStatistics : public StatisticsGroup {
    std::string prefix_;
    std::deque<std::string> names_;

    Counter& add(const char* name, const char* unit, const char* meaning) {
        return count(names_.emplace_back(prefix_ + '_' + name), unit, meaning);
    }

public:
    explicit BlockStatistics(std::string_view prefix)
        : prefix_(prefix) {}

    Counter& cleared = add("cleared", "blocks", "of which a clear wrote the state only");
    Counter& cleared_slowly = add("cleared_slowly", "blocks", "that a clear wrote to memory");
    Counter& cleared_reads = add("cleared_reads", "blocks", "filled from their state, not read");
    Counter& cleared_read_bytes = add("cleared_read_bytes", "bytes", "not read, of cleared blocks");
    Counter& compressed_reads = add("compressed_reads", "blocks", "read compressed");
    Counter& compressed_read_bytes =
        add("compressed_read_bytes", "bytes", "not read, of compressed blocks");
    Counter& compressed_writes = add("compressed_writes", "blocks", "written compressed");
    Counter& plain_writes = add("plain_writes", "blocks", "written as they are");
    Counter& saved_write_bytes =
        add("saved_write_bytes", "bytes", "dirty, but not written: codes are shorter");
    Counter& completed_write_bytes = add(
        "completed_write_bytes", "bytes", "not dirty, but written: memory did not hold them plain");
    Counter& merge_read_bytes =
        add("merge_read_bytes", "bytes", "read to complete a block that is written");
    Counter& resolved = add("resolved", "blocks", "made plain for a clear, a copy or the host");
};

} // namespace ffgpu::timing
