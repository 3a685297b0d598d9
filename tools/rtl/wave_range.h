// The option that says of which cycles waves are written.

#pragma once

#include "rtl/loop/rtl_stages.h"

#include <string>

namespace ffgpu::tools {

// "3-7", "3" or "3-"; of an empty text all cycles. Throws InputError.
rtl::WaveCycles parse_wave_cycles(const std::string& text);

} // namespace ffgpu::tools
