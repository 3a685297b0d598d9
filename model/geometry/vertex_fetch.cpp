#include "model/geometry/vertex_fetch.h"

#include "model/device/extents.h"

#include <algorithm>
#include <cstring>

namespace ffgpu {
namespace {

// Bytes from the first vertex to the end of the last.
std::uint64_t extent(const VertexFormat& format, std::uint32_t vertex_count) {
    std::uint64_t words = 0;
    for (const VertexElement& element : format.elements)
        if (element.components != 0)
            words = std::max<std::uint64_t>(words, element.offset + element.components);
    return 4 * (std::uint64_t{format.stride} * (vertex_count - 1) + words);
}

template <unsigned Components>
void fetch_attribute(const std::byte* first,
                     std::size_t stride,
                     std::span<const std::uint32_t> numbers,
                     Planes4& planes) {
    for (std::size_t lane = 0; lane < numbers.size(); ++lane) {
        const std::byte* const value = first + numbers[lane] * stride;
        for (unsigned i = 0; i < Components; ++i)
            std::memcpy(&planes[i].lanes[lane], value + i * sizeof(float), sizeof(float));
    }
}

} // namespace

ElementReader::ElementReader(std::span<const std::byte> memory,
                             const DrawCommand& command,
                             const VertexFormat& format)
    : command_(command) {
    if (command.vertex_count == 0) return;
    const std::uint64_t vertices = extent(format, command.vertex_count);
    in_memory_ =
        lies_within(command.vertex_address, vertices, memory.size()) &&
        (!indexed() || lies_within(command.index_address, index_bytes(command), memory.size()));
    if (in_memory_ && indexed()) indices_ = memory.data() + command.index_address;
}

template <class Index>
void ElementReader::read_indices(std::uint32_t first, std::span<std::uint32_t> numbers) const {
    const std::uint32_t last = command_.vertex_count - 1;
    const std::byte* from = indices_ + std::size_t{first} * sizeof(Index);
    for (std::uint32_t& number : numbers) {
        Index index;
        std::memcpy(&index, from, sizeof index);
        number = std::min<std::uint32_t>(index, last);
        from += sizeof index;
    }
}

void ElementReader::read(std::uint32_t first, std::span<std::uint32_t> numbers) const {
    switch (command_.index_type) {
    case IndexType::U16:
        return read_indices<std::uint16_t>(first, numbers);
    case IndexType::U32:
        return read_indices<std::uint32_t>(first, numbers);
    default:
        break;
    }
    const std::uint64_t last = command_.vertex_count - 1;
    std::uint64_t number = std::uint64_t{command_.first} + first;
    for (std::uint32_t& result : numbers)
        result = static_cast<std::uint32_t>(std::min(number++, last));
}

void VertexFetch::start(const VertexSetup& setup, VertexBatch& batch) {
    const VertexFormat& format = setup.registers->vertex_format;
    count_ = 0;
    stride_ = std::size_t{4} * format.stride;
    for (unsigned attribute = 0; attribute < Attributes; ++attribute) {
        if (!setup.read[attribute]) continue;
        const VertexElement& element = format.elements[attribute];
        const unsigned components = std::min<unsigned>(element.components, 4);
        if (components != 0) {
            sources_[count_++] = {static_cast<std::uint8_t>(attribute),
                                  static_cast<std::uint8_t>(components),
                                  4u * element.offset};
        }
        constexpr Vec4 Missing{0, 0, 0, 1};
        const Vec4& constant =
            components == 0 ? setup.registers->current.values[attribute] : Missing;
        for (unsigned i = components; i < 4; ++i)
            batch.in[attribute][i].lanes.fill(constant[i]);
    }
}

void VertexFetch::fetch(const std::byte* vertices,
                        std::span<const std::uint32_t> numbers,
                        VertexBatch& batch) const {
    batch.count = static_cast<unsigned>(numbers.size());
    for (const Source& source : std::span(sources_).first(count_)) {
        const std::byte* first = vertices + source.offset;
        Planes4& planes = batch.in[source.attribute];
        switch (source.components) {
        case 1:
            fetch_attribute<1>(first, stride_, numbers, planes);
            break;
        case 2:
            fetch_attribute<2>(first, stride_, numbers, planes);
            break;
        case 3:
            fetch_attribute<3>(first, stride_, numbers, planes);
            break;
        default:
            fetch_attribute<4>(first, stride_, numbers, planes);
            break;
        }
    }
}

} // namespace ffgpu
