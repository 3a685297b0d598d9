#include "model/work/whole_command.h"

namespace ffgpu::work {

// As if of batches of as many quads as there can be.
TexelFootprints& WholeCommand::own_footprints(std::size_t unit) {
    for (std::size_t quad = sources.size(), end = quads.size(); quad < end; ++quad)
        sources.push_back({static_cast<std::uint32_t>(quad / BatchQuads),
                           static_cast<std::uint32_t>(quad % BatchQuads)});
    const std::size_t batch = sources.back().batch;
    const std::size_t at = batch * units.size() + unit;
    if (at >= own.size()) {
        own.resize((batch + 1) * units.size());
        footprints.resize(own.size());
    }
    if (!own[at]) {
        own[at] = std::make_shared<TexelFootprints>();
        own[at]->unit = units[unit];
        footprints[at] = own[at].get();
    }
    return *own[at];
}

} // namespace ffgpu::work
