// CommandTrace: what goes out on the DRAM's command buses, as lines of text, for programs that
// check timings or reckon power. It listens on the machine's thread and writes on one of its own;
// what waits between is bounded.

#pragma once

#include "model/timing/memory/config.h"
#include "model/timing/memory/dram_commands.h"
#include "model/work/job_thread.h"
#include "tools/export/text_writer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace ffgpu::tools {

class CommandTrace final : public timing::DramCommandObserver {
public:
    CommandTrace(const timing::MemoryConfig& memory, TextWriter& out);

    // Lines of one channel come in the order of their cycles.
    void issued(const timing::IssuedCommand& command) override;

    // Throws what went wrong with writing.
    void check_failure() { writer_.check_failure(); }
    // Nothing more comes: returns when all is handed to the text writer.
    void finish();

    // By DramOperation.
    using Counts = std::array<std::uint64_t, timing::DramOperationNames.size()>;
    const Counts& counts() const { return counts_; }

private:
    static constexpr std::size_t Chunk = std::size_t{1} << 14;

    // A request's columns that have not gone out yet: how many bursts, from this one on.
    using Later = std::optional<timing::IssuedCommand>;

    void write_before(Later& later, timing::MemoryCycle end);
    void write(const timing::IssuedCommand& command);
    void write_chunk();

    const std::uint32_t burst_bytes_, spacing_;
    TextWriter& out_;
    std::vector<Later> later_; // by channels
    Counts counts_{};
    std::vector<timing::IssuedCommand> chunk_;
    work::JobThread writer_; // The last: its thread uses the others.
};

} // namespace ffgpu::tools
