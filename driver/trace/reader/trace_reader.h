// TraceReader: reads an apitrace file call by call. A call is delivered when the traced program
// left it, with its results; calls of several threads may interleave. Memory is bounded: one chunk
// of the file and the calls that are not left yet.
//
// The format is apitrace's docs/FORMAT.markdown, as its lib/trace/trace_parser.cpp reads it.

#pragma once

#include "driver/trace/reader/byte_stream.h"
#include "driver/trace/reader/call.h"
#include "driver/trace/reader/id_table.h"
#include "driver/trace/reader/value_parser.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::trace {

constexpr std::uint64_t MaxTraceVersion = 6;

class TraceReader {
public:
    // Throws InputError for a file that is not a trace, or of a newer version than ours.
    explicit TraceReader(std::string path);
    ~TraceReader();

    // The next call, or null at the end of the file. The call lives until the next next(). Where
    // the file is damaged, all calls before the place are delivered; then InputError is thrown,
    // naming the file, the place, and what was expected.
    Call* next();

    // Keeps the call that next() returned last beyond the next next().
    std::unique_ptr<Call> take() { return std::move(delivered_); }

    // Back to the first call.
    void rewind();

    const std::string& path() const { return path_; }
    std::uint64_t version() const { return version_; }
    // Of the uncompressed file, so far.
    std::uint64_t bytes_read() const { return stream_.position(); }

private:
    struct StackFrame {};

    void read_header();
    Call* next_or_damage();
    void parse_enter();
    Call* parse_leave();
    void parse_details(Call& call);
    void parse_argument(Call& call);
    void parse_backtrace();
    std::string parse_identifier();
    const Signature& parse_signature();
    Call& begin_call(const Signature& signature, std::uint32_t thread);
    std::string place() const;

    std::string path_;
    ByteStream stream_;
    std::uint64_t version_ = 0;
    std::uint64_t next_number_ = 0;
    std::optional<ValueParser> values_;
    IdTable<Signature> signatures_;
    IdTable<StackFrame> frames_;
    std::vector<std::unique_ptr<Call>> pending_; // entered and not left, in order
    std::vector<std::unique_ptr<Call>> spare_;   // to be used again, memory and all
    std::unique_ptr<Call> delivered_;
};

} // namespace ffgpu::trace
