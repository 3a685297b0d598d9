// PictureList: pictures.csv, which pictures a run wrote of each frame, with figures that tell
// whether stats.json beside it is of the same work and machine. It is a file of its own because
// stats.json is the same from a work file, which has no pictures.

#pragma once

#include "model/work/frame_figures.h"
#include "tools/report/text_spool.h"

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

namespace ffgpu::tools {

constexpr const char* PictureListName = "pictures.csv";

// All may be called from any thread. They throw InputError where a file cannot be written.
class PictureList {
public:
    // The frame's pictures by what comes before its number: "frame", "heat_cycles" ...
    void add(const work::FrameFigures& frame, const std::vector<std::string>& pictures);
    // What the first of the frames that were added, and are not timed yet, took; 0: without timing.
    void timed(std::uint64_t cycles);

    // The frames that are timed.
    void write(const std::string& folder) const;

private:
    struct Row {
        std::uint64_t frame, covered, written;
        std::string pictures;
    };
    mutable std::mutex mutex_;
    std::deque<Row> untimed_;
    TextSpool rows_;
};

} // namespace ffgpu::tools
