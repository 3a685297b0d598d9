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

void convert_vertex(const VertexFormat& from,
                    const VertexFormat& to,
                    const float* source,
                    float* destination) {
    for (std::size_t a = 0; a < Attributes; ++a) {
        const VertexElement old = from.elements[a];
        const VertexElement wide = to.elements[a];
        for (unsigned c = 0; c < wide.components; ++c) {
            destination[wide.offset + c] =
                c < old.components ? source[old.offset + c] : MissingComponents[c];
        }
    }
}

} // namespace ffgpu::gl
