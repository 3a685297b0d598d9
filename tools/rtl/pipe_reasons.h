// What the fragment pipe in RTL leaves to the model, draw by draw.

#pragma once

#include "tools/rtl/pipe_records.h"

#include <string>

namespace ffgpu::tools {

// Why the pipe does not draw it; empty: it does.
std::string reason_against_pipe(const PipeRecords& records);

} // namespace ffgpu::tools
