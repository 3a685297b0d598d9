#include "model/gpu/validate.h"

#include "model/base/input_error.h"
#include "model/device/enumerators.h"
#include "model/memory/pixel_format.h"

#include <string>
#include <type_traits>

namespace ffgpu {
namespace {

void require(bool condition, const char* what) {
    if (!condition) throw InputError(what);
}

template <class Packed>
void validate_enumerators(const Packed& packed, const char* owner) {
    if (const char* const field = find_bad_enumerator(packed))
        throw InputError(std::string(owner) + '.' + field + " holds no value of its kind");
}

void validate_vertex_format(const VertexFormat& format) {
    require(format.stride > 0, "vertex_format.stride is 0");
    for (const VertexElement& element : format.elements) {
        require(element.components <= 4, "vertex_format.components exceeds 4");
        require(element.offset + element.components <= format.stride,
                "a vertex element lies outside the vertex");
    }
}

void validate_target(const Surface& surface, bool depth, std::uint64_t memory_size) {
    if (surface.format == Format::None) return;
    require(depth ? is_depth_target(surface.format) : is_plain_color(surface.format),
            "a target's format is not one of targets");
    require(surface.samples == 1 || surface.samples == MaxSamples,
            "a target has a number of samples that no target has");
    require(surface.width <= MaxSurfaceSize && surface.height <= MaxSurfaceSize,
            "a target exceeds the largest surface");
    require(surface_fits(surface, memory_size), "a target does not lie in device memory");
}

} // namespace

void validate(const Registers& registers, std::uint64_t memory_size) {
    Registers::visit(registers, [](const auto& reg) {
        validate_enumerators(reg, std::remove_cvref_t<decltype(reg)>::Name);
    });
    validate_vertex_format(registers.vertex_format);
    for (const Surface& color : registers.targets.color)
        validate_target(color, false, memory_size);
    validate_target(registers.targets.depth, true, memory_size);
    const unsigned samples = registers.targets.samples();
    Targets::for_each(registers.targets, [samples](const Surface& target) {
        require(target.format == Format::None || target.samples == samples,
                "the targets differ in their samples");
    });
    const unsigned factor = registers.primitive.line_stipple_factor;
    require(factor >= 1 && factor <= 256, "line_stipple_factor is not 1 to 256");
}

void validate(const DrawCommand& draw, const Registers& registers, std::uint64_t memory_size) {
    validate_enumerators(draw, "draw");
    const auto fits = [memory_size](std::uint64_t at, std::uint64_t count, std::uint64_t bytes) {
        return at <= memory_size && count * bytes <= memory_size - at;
    };
    const std::uint64_t vertex_bytes = std::uint64_t{registers.vertex_format.stride} * 4;
    require(fits(draw.vertex_address, draw.vertex_count, vertex_bytes),
            "the vertices do not lie in device memory");
    require(draw.vertex_count > 0 || draw.count == 0, "a draw without vertices in memory");
    if (draw.index_type == IndexType::None) {
        require(std::uint64_t{draw.first} + draw.count <= draw.vertex_count,
                "the vertices drawn exceed those in memory");
    } else {
        const std::uint64_t index_bytes = draw.index_type == IndexType::U16 ? 2 : 4;
        require(fits(draw.index_address, draw.count, index_bytes),
                "the indices do not lie in device memory");
    }
    if (draw.output == DrawOutput::Feedback)
        require(draw.feedback_bytes >= 4 && fits(draw.feedback_address, draw.feedback_bytes, 1),
                "the feedback buffer does not lie in device memory");
}

void validate(const DrawImageCommand& image) {
    validate_enumerators(image, "draw_image");
}

void validate(const CopyRectangleCommand& copy, std::uint64_t memory_size) {
    validate_enumerators(copy, "copy_rectangle");
    for (const Surface* surface : {&copy.source, &copy.destination})
        require(surface_fits(*surface, memory_size), "a surface does not lie in device memory");
    require(copy.source_x + copy.width <= copy.source.width &&
                copy.source_y + copy.height <= copy.source.height &&
                copy.destination_x + copy.width <= copy.destination.width &&
                copy.destination_y + copy.height <= copy.destination.height,
            "a rectangle leaves its surface");
}

} // namespace ffgpu
