// StatisticsReport: stats.json. Equal for equal input and configuration, byte for byte: it holds no
// time, no thread count, no path. docs/stats.md is its schema. What frames leave waits in a file:
// memory does not grow with their number.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/gpu_timing.h"
#include "tools/config/configuration.h"
#include "tools/replay/frame_source.h"
#include "tools/replay/text_spool.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

class StatisticsReport {
public:
    explicit StatisticsReport(const Configuration& configuration, bool with_timing);
    ~StatisticsReport();

    using Groups = std::vector<const StatisticsGroup*>;

    // From here on a frame counts.
    void begin_frame(const Groups& functional, const Groups& timing);

    // What was counted since begin_frame() is the frame's. `cycles`: of the timing model.
    void end_frame(const Frame& frame,
                   const Groups& functional,
                   const Groups& timing,
                   const std::optional<timing::FrameTiming>& cycles);

    // The whole file so far.
    void write(const TextSink& out) const;

    // A few lines for people.
    std::string summary() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

} // namespace ffgpu::tools
