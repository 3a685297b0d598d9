#include "model/work/whole_command.h"

namespace ffgpu::work {

// As if of batches of as many quads as there can be.
void WholeCommand::add_access(std::size_t unit, TexelAccess access) {
    while (sources.size() < quads.size())
        sources.push_back({static_cast<std::uint32_t>(sources.size() / BatchQuads),
                           static_cast<std::uint32_t>(sources.size() % BatchQuads)});
    const QuadOfBatch& last = sources.back();
    own.resize((last.batch + std::size_t{1}) * units.size());
    footprints.resize(own.size());
    const std::size_t at = last.batch * units.size() + unit;
    if (!own[at]) {
        own[at] = std::make_shared<TexelFootprints>();
        own[at]->unit = units[unit];
        footprints[at] = own[at].get();
    }
    access.lane = static_cast<std::uint16_t>(4 * last.quad + access.lane % 4u);
    own[at]->add(access);
}

} // namespace ffgpu::work
