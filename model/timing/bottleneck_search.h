// BottleneckSearch: looks for bottlenecks beside the machine. A watch notes what the stages do; on
// a thread of its own, which no result depends on, it is reckoned from that what was waited for.

#pragma once

#include "model/base/cache_lines.h"
#include "model/timing/bottlenecks.h"
#include "model/timing/frame_waits.h"
#include "model/timing/memory_statistics.h"
#include "model/timing/pipe_log.h"
#include "model/timing/pipe_watch.h"
#include "model/work/job_thread.h"

#include <array>
#include <memory>

namespace ffgpu::timing {

class BottleneckStatistics : public NamedStatistics {
public:
    // Of an interpolator only where there is one.
    explicit BottleneckStatistics(bool interpolates);
    // Of a frame that began after cycle `begin`.
    void count(const FrameWaits& waits, Cycle begin);

private:
    std::array<Counter*, Resources> waited_{}, gained_{};
};

class BottleneckSearch {
public:
    // `beside`: on a thread of its own, else at once. Links are connected.
    BottleneckSearch(const Clock& clock, PipeParts parts, bool beside);

    // Is told of the memory's answers.
    MemoryObserver& watch() { return watch_; }
    // At the end of each cycle in which a unit was due; whose it is.
    void end_cycle(std::size_t charged);
    // A frame ended with this cycle. Waits until all is reckoned.
    FrameWaits end_frame();

private:
    void hand_over();

    const Clock& clock_;
    const PipeParts parts_;
    PipeWatch watch_; // written by the machine's thread, the rest on the other's
    alignas(CacheLinePair) Bottlenecks bottlenecks_;
    // One is written, one read, and as many as the thread lets wait are between the two.
    static constexpr std::size_t Waiting = 2;
    std::array<PipeLog, Waiting + 2> logs_;
    std::size_t written_ = 0;
    std::unique_ptr<work::JobThread> thread_; // null: none. The last: it uses the others.
};

} // namespace ffgpu::timing
