// Exports of an application's memory traffic and of the machine's time, for other tools:
// docs/export.md has a section for each format.

#pragma once

#include "model/work/lookups.h"
#include "tools/config/configuration.h"
#include "tools/frames/frame_range.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace ffgpu::tools {

enum class ExportFormat : std::uint8_t {
    Din,
    Xdin,
    Ramulator2,
    Ramulator2Vectors,
    Dramsim3,
    Dramsys,
    Csv,
    DramCommands,
    Perfetto,
    Vcd,
    Fst
};
inline constexpr std::array<std::string_view, 11> ExportFormatNames{"din",
                                                                    "xdin",
                                                                    "ramulator2",
                                                                    "ramulator2_vectors",
                                                                    "dramsim3",
                                                                    "dramsys",
                                                                    "csv",
                                                                    "dram_commands",
                                                                    "perfetto",
                                                                    "vcd",
                                                                    "fst"};

// Whether the option of that name decides anything in this format.
bool has_client(ExportFormat format);
bool has_access_bytes(ExportFormat format);

struct ExportOptions {
    std::string input{};
    std::string output = "-"; // a file; "-": standard output
    ExportFormat format = ExportFormat::Din;
    FrameRange frames{};
    std::uint64_t ends_behind = FrameRange{}.last; // this frame, of any input
    Configuration configuration{};
    work::LookupClient client = work::LookupClient::Texel; // has_client()
    std::uint32_t access_bytes = 64;                       // of a record; has_access_bytes()
    bool compresses = false;
    std::function<void(const std::string& line)> warn = [](const std::string&) {};
};

// Throws InputError for a name that is none, with the nearest that is.
ExportFormat parse_export_format(const std::string& name);

// Returns a summary for people. What comes behind the last frame is left out, but where it goes to
// no file it has gone when that is known. Throws InputError; what was exported before a fault of
// the input is kept, what a full disk cut off is not.
std::string export_trace(const ExportOptions& options);

} // namespace ffgpu::tools
