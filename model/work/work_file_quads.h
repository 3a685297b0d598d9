// WorkFileQuads: reads the quads of a work file's commands, each from where the one before it lay:
// its place, its masks, the texels that it read, and its values where they were kept.

#pragma once

#include "model/work/column_bytes.h"
#include "model/work/value_columns.h"
#include "model/work/whole_command.h"

namespace ffgpu::work {

class WorkFileQuads {
public:
    // Reads from `in`, whatever block it holds.
    explicit WorkFileQuads(ColumnReader& in)
        : in_(in) {}

    // Reads the next quad behind those that the command has. Throws DamagedItem.
    void append_quad(WholeCommand& command);

private:
    void read_accesses(WholeCommand& command);
    void read_values(WholeCommand& command);

    ColumnReader& in_;
    AccessForecast forecast_;
    ValueColumnReader values_in_;
};

} // namespace ffgpu::work
