// A landscape, as heights for relief.

#pragma once

#include "techniques/image.h"

namespace ffgpu::gallery {

// In [0, 1], periodic: waves that cross, and round hills. Field's rows are v.
techniques::Field hills(int size);

} // namespace ffgpu::gallery
