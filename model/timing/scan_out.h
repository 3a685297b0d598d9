// ScanOut: the screen reads the shown surface, line after line of memory, evenly over the refresh
// period: the surface of the frame that ended last, from its beginning at the next refresh. A line
// that could not be asked for when it was due is counted as late.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/request_port.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class ScanOutStatistics : public StatisticsGroup {
public:
    Counter& refreshes = count("scan_out_refreshes", "refreshes", "of the screen that ended");
    Counter& late_lines = count("scan_out_late_lines", "lines", "asked for after they were due");
};

class ScanOut final : public Unit {
public:
    struct Ports {
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
    };

    ScanOut(sc_core::sc_module_name name,
            const Clock& clock,
            const ScanOutConfig& config,
            const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

    // The host's side: a frame ended, with its picture there.
    void show(std::uint64_t address, std::uint64_t bytes) {
        shown_ = {address, (bytes + config_.line_bytes - 1) / config_.line_bytes};
        wake();
    }

    std::string state() const override;
    const ScanOutStatistics& statistics() const { return statistics_; }

private:
    struct Surface {
        std::uint64_t address = 0, lines = 0;
    };

    Activity step() override;
    Cycle next_work(Activity last) const override;
    // The cycle in which the next line is due.
    Cycle due() const { return begin_ + next_ * config_.refresh_cycles / surface_.lines; }

    const ScanOutConfig config_;
    const Ports ports_;
    ScanOutStatistics statistics_;
    Surface shown_, surface_;
    Cycle begin_ = 0;        // of the refresh
    std::uint64_t next_ = 0; // line
    std::uint32_t outstanding_ = 0;
};

} // namespace ffgpu::timing
