#include "model/work/prepared_work.h"

#include "model/base/check.h"

namespace ffgpu::work {

QuadValues PreparedQuads::values_of(const PreparedDraw& draw, const PreparedQuad& quad) const {
    const QuadValueKinds& kinds = draw.value_kinds;
    const auto samples = [&](std::uint16_t of_samples, std::uint8_t lanes) {
        return kinds.multisampled ? of_samples : lanes_to_samples(lanes);
    };
    QuadValues parsed;
    const bool fits =
        QuadValues::parse(kinds,
                          samples(quad.samples_covered, quad.covered),
                          samples(quad.samples_written, quad.after_depth),
                          std::span(values).subspan(quad.values_begin, quad.value_count),
                          parsed);
    check(fits, "a quad's values are those of its masks");
    return parsed;
}

} // namespace ffgpu::work
