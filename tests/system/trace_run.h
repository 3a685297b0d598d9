// A whole trace through driver, functional GPU and, where wanted, the timing model, with the
// choices that must not change a pixel.

#pragma once

#include "model/timing/config.h"
#include "tools/frames/frame_range.h"
#include "tools/image/image.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::tools {

struct Picture {
    std::uint64_t frame = 0;
    unsigned width = 0, height = 0;
    std::uint64_t hash = 0; // of the RGB bytes, the top row first: 64-bit FNV-1a
    bool operator==(const Picture&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Picture& picture);

Picture picture_of(std::uint64_t frame, const Image& image);

// How a device is handed the driver's commands.
enum class Grouping : std::uint8_t {
    AsGiven,
    OneByOne, // Each command in a stream of its own, and finished before the next.
    Halves,   // OneByOne, and draws of separate primitives in two.
};

struct RunOptions {
    unsigned threads = 1;
    unsigned tile_size = 64;
    std::size_t bin_bytes = std::size_t{512} << 10;
    Grouping grouping = Grouping::AsGiven;
    bool record_work = false;
    bool reference = false; // with the scalar specifications
    std::optional<timing::TimingConfig> timing{};
    std::uint64_t last_frame = ~std::uint64_t{0};
};

using Counters = std::map<std::string, std::uint64_t>;

struct Run {
    std::vector<Picture> pictures;
    Counters functional;               // at the end
    Counters host;                     // how the host drew
    Counters timed;                    // with timing
    std::vector<std::uint64_t> cycles; // of each frame, with timing
    std::vector<std::pair<std::uint32_t, std::uint64_t>> draw_cycles;
};

Run run_trace(const std::string& path, const RunOptions& options);

// The project's own traces, by name, and those of the gallery's programs, as "gallery/noise".
std::vector<std::string> own_traces();
std::vector<std::string> gallery_traces();
std::string own_trace(const std::string& name);

// Traces of real programs: FFGPU_WORKLOADS, or beside the source tree; may not exist.
std::filesystem::path workloads();
// Their names; none, with a warning in the test's output, where they are not installed.
std::vector<std::string> workload_traces();
std::string workload_trace(const std::string& name);

} // namespace ffgpu::tools
