// A small trace, and what a reader delivers of a file's bytes.

#pragma once

#include "driver/trace/reader/trace_reader.h"
#include "model/base/input_error.h"
#include "tests/support/temporary_file.h"
#include "tests/trace/trace_writer.h"

#include <string>
#include <vector>

namespace ffgpu::trace {

// What was delivered before the end or the damage, and the damage.
struct Outcome {
    std::vector<std::string> names;
    std::string error;
    bool operator==(const Outcome&) const = default;
};

inline Outcome read_all(const std::string& file_bytes) {
    const TemporaryFile file(file_bytes);
    Outcome outcome;
    try {
        TraceReader reader(file.path());
        while (const Call* const call = reader.next())
            outcome.names.emplace_back(call->name());
    } catch (const InputError& error) {
        outcome.error = error.what();
    }
    return outcome;
}

// Three calls; the second with many kinds of values.
inline TraceWriter small_trace() {
    TraceWriter writer;
    writer.call(0, "glClear", {"mask"}, {[&] { writer.bitmask(0, 0x4100); }});
    writer.call(1,
                "glTexImage2D",
                {"target", "width", "pixels"},
                {[&] { writer.enumeration(0, 0x0de1); },
                 [&] { writer.sint(4); },
                 [&] { writer.blob(std::string(3000, 'x')); }});
    writer.call(0, "glClear", {"mask"}, {[&] { writer.bitmask(0, 0x100); }});
    return writer;
}

} // namespace ffgpu::trace
