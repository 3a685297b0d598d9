#include "driver/vertex/vertex_run.h"

#include <algorithm>

namespace ffgpu::gl {

VertexFormat widen(const VertexFormat& format, Attribute attribute, unsigned components) {
    VertexFormat wide = format;
    VertexElement& element = wide.elements[attribute_index(attribute)];
    element.components =
        static_cast<std::uint8_t>(std::max<unsigned>(element.components, components));
    unsigned offset = 0;
    for (VertexElement& each : wide.elements) {
        each.offset = static_cast<std::uint8_t>(each.components == 0 ? 0 : offset);
        offset += each.components;
    }
    wide.stride = static_cast<std::uint8_t>(offset);
    return wide;
}

} // namespace ffgpu::gl
