#include "tools/time/measured_gains.h"

#include "model/base/whole_file.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/without_limit.h"
#include "model/work/work_file_reader.h"
#include "tools/replay/interruption.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using timing::Resource;
using timing::Resources;

void play(const std::string& work,
          const timing::TimingConfig& config,
          const timing::MakeMemory& memory,
          const std::function<void(const timing::FrameTiming&)>& on_frame) {
    timing::GpuTiming timing(config, {}, memory);
    timing.set_on_frame(on_frame);
    timing.let_frames_overlap();
    work::WorkFileReader file(work);
    file.play(timing, [&](const work::FrameFigures&) {
        if (Interruption::signal() != 0) file.stop();
    });
    timing.catch_up();
}

double reckoned_gain(const timing::FrameTiming& frame, Resource resource) {
    double gain = 0;
    for (const timing::CommandCycles& command : frame.commands)
        gain += static_cast<double>(command.saved[resource]);
    return gain;
}

std::int64_t gain(std::uint64_t with, std::uint64_t without) {
    return static_cast<std::int64_t>(with) - static_cast<std::int64_t>(without);
}

std::filesystem::path gains_file(const std::string& folder) {
    return std::filesystem::path(folder) / "gains.csv";
}

std::string_view name_of(Resource resource) {
    return timing::ResourceNames[static_cast<std::size_t>(resource)];
}

} // namespace

std::vector<FrameGains> measure_gains(const std::string& work, const timing::TimingConfig& config) {
    std::vector<Resource> limited;
    for (std::size_t i = 0; i < Resources; ++i)
        if (timing::has_limit(config, static_cast<Resource>(i)))
            limited.push_back(static_cast<Resource>(i));

    std::vector<FrameGains> frames;
    play(work, config, {}, [&](const timing::FrameTiming& frame) {
        FrameGains& gains = frames.emplace_back();
        gains.frame = frame.frame;
        gains.cycles = frame.cycles;
        for (const Resource resource : limited)
            gains.without.push_back({resource, 0, reckoned_gain(frame, resource)});
    });
    for (std::size_t i = 0; i < limited.size(); ++i) {
        if (Interruption::signal() != 0) return {};
        timing::TimingConfig faster = timing::without_limit(config, limited[i]);
        faster.bottlenecks.enable = false;
        std::size_t frame = 0;
        play(
            work, faster, timing::memory_as_deep_as(config), [&](const timing::FrameTiming& timed) {
                frames.at(frame++).without[i].cycles = timed.cycles;
            });
    }
    if (Interruption::signal() != 0) return {};
    return frames;
}

void remove_gains_file(const std::string& folder) {
    std::error_code none_there;
    std::filesystem::remove(gains_file(folder), none_there);
}

void write_gains_file(const std::vector<FrameGains>& frames, const std::string& folder) {
    WholeFile file(gains_file(folder).string());
    file.write("frame,resource,cycles,cycles_without,gain,reckoned_gain\n");
    for (const FrameGains& frame : frames)
        for (const FrameGains::Without& without : frame.without)
            file.write(fmt::format("{},{},{},{},{},{:.0f}\n",
                                   frame.frame,
                                   name_of(without.resource),
                                   frame.cycles,
                                   without.cycles,
                                   gain(frame.cycles, without.cycles),
                                   std::round(without.reckoned)));
    file.commit();
}

std::string gains_summary(const std::vector<FrameGains>& frames) {
    if (frames.empty()) return {};
    FrameGains sums = frames.front();
    for (auto frame = frames.begin() + 1; frame != frames.end(); ++frame) {
        sums.cycles += frame->cycles;
        for (std::size_t i = 0; i < sums.without.size(); ++i) {
            sums.without[i].cycles += frame->without[i].cycles;
            sums.without[i].reckoned += frame->without[i].reckoned;
        }
    }
    std::stable_sort(sums.without.begin(), sums.without.end(), [](const auto& a, const auto& b) {
        return a.cycles < b.cycles;
    });
    std::string text = fmt::format("{} cycles; without the limits of one resource\n"
                                   "  {:20}{:>12}{:>10}{:>12}\n",
                                   sums.cycles,
                                   "",
                                   "cycles",
                                   "gain",
                                   "reckoned");
    const auto percent = [&](double cycles) {
        return 100 * cycles / static_cast<double>(std::max<std::uint64_t>(sums.cycles, 1));
    };
    for (const FrameGains::Without& without : sums.without)
        text += fmt::format("  {:20}{:>12}{:>8.1f} %{:>10.1f} %\n",
                            name_of(without.resource),
                            without.cycles,
                            percent(static_cast<double>(gain(sums.cycles, without.cycles))),
                            percent(without.reckoned));
    return text;
}

} // namespace ffgpu::tools
