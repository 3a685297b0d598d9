// Occlusion queries (GL 1.5, 4.1.7 and 6.1.12). Their names are a context's own: they are not
// shared.

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/device_block.h"
#include "driver/objects/name_table.h"

namespace ffgpu::gl {

// A name becomes an object with its first glBeginQuery.
struct QueryObject {
    DeviceBlock result; // 8 bytes: the samples of the last query that ended
};

struct QueryObjects {
    NameTable<QueryObject> names;
    GLuint active = 0; // between glBeginQuery and glEndQuery; 0: none
};

} // namespace ffgpu::gl
