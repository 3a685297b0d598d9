// QuadColumnWriter: the columns of a work file that tell quads and what they read. Quads are
// written some at a time, a column after the other.

#pragma once

#include "model/work/column_bytes.h"
#include "model/work/value_columns.h"
#include "model/work/whole_command.h"
#include "model/work/work_file_format.h"

#include <cstddef>

namespace ffgpu::work {

class QuadColumnWriter {
public:
    static constexpr std::size_t MostQuads = 64; // at a time

    // The bytes that `count` quads from `first` on take at most.
    std::size_t most_bytes(const WholeCommand& command, std::size_t first, std::size_t count) const;
    // Before the first quad of a command.
    void begin(const WholeCommand& command);

    void
    write(const WholeCommand& command, std::size_t first, std::size_t count, ColumnWriter& columns);

private:
    void write_accesses(const WholeCommand& command,
                        std::size_t first,
                        std::size_t count,
                        ColumnWriter& columns);

    AccessForecast forecast_;
    std::size_t most_accesses_ = 0; // of a quad of the command
    ValueColumnWriter values_;
};

} // namespace ffgpu::work
