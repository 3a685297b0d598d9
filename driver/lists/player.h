// Carries out the records of a display list.

#pragma once

#include <cstddef>
#include <span>

namespace ffgpu::gl {

class Context;

void play_records(Context& context, std::span<const std::byte> code);

} // namespace ffgpu::gl
