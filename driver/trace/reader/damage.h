// Damage: what is wrong with a file, without the file's name and the place, which only the caller
// that knows them adds (see TraceReader::next).

#pragma once

#include <string>

namespace ffgpu::trace {

struct Damage {
    std::string what;
};

} // namespace ffgpu::trace
