// Occlusion queries (GL 1.5, 4.1.7 and 6.1.12). Their names are a context's own: they are not
// shared.

#pragma once

#include "driver/gl_types.h"
#include "driver/objects/device_block.h"

#include <map>

namespace ffgpu::gl {

struct QueryObject {
    bool begun = false; // A name is an object from its first glBeginQuery on.
    DeviceBlock result; // 8 bytes: the samples of the last query that ended
};

struct QueryObjects {
    std::map<GLuint, QueryObject> objects; // names in use
    GLuint active = 0;                     // between glBeginQuery and glEndQuery; 0: none
};

} // namespace ffgpu::gl
