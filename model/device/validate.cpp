#include "model/device/validate.h"

#include "model/base/input_error.h"
#include "model/device/enumerators.h"
#include "model/device/extents.h"

#include <string>
#include <type_traits>

namespace ffgpu {
namespace {

void require(bool condition, const char* what) {
    if (!condition) throw InputError(what);
}

template <class Packed>
void validate_enumerators(const Packed& packed) {
    if (const auto field = find_bad_enumerator(packed))
        throw InputError(std::string(Packed::Name) + '.' + field->text() +
                         " holds no value of its kind");
}

void validate_vertex_format(const VertexFormat& format) {
    require(format.stride > 0, "vertex_format.stride is 0");
    for (const VertexElement& element : format.elements) {
        require(element.components <= 4, "vertex_format.components exceeds 4");
        require(element.offset + element.components <= format.stride,
                "a vertex element lies outside the vertex");
    }
}

void validate_texture(const TextureImage& image, std::uint64_t memory_size) {
    const TextureShape& shape = image.shape;
    if (shape.kind == TextureKind::None) return;
    require(shape.format != Format::None && shape.format < Format::Stencil8,
            "a texture image's format is not one of texels");
    require(shape.width > 0 && shape.height > 0 && shape.depth > 0, "a texture image is empty");
    require(shape.width <= MaxTextureSize && shape.height <= MaxTextureSize &&
                shape.depth <= MaxTexture3dSize,
            "a texture image exceeds the largest");
    require(shape.levels >= 1 && shape.levels <= MaxTextureLevels,
            "a texture image has a number of levels that no image has");
    require(texture_fits(image, memory_size), "a texture image does not lie in device memory");
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

void validate_targets(const Targets& targets, std::uint64_t memory_size) {
    for (const Surface& color : targets.color)
        validate_target(color, false, memory_size);
    validate_target(targets.depth, true, memory_size);
    Targets::for_each(targets, [samples = targets.samples()](const Surface& target) {
        require(target.format == Format::None || target.samples == samples,
                "the targets differ in their samples");
    });
}

} // namespace

void validate(const Registers& registers, std::uint64_t memory_size) {
    Registers::visit(registers, [](const auto& reg) { validate_enumerators(reg); });
    validate_vertex_format(registers.vertex_format);
    for (const TextureImage& image : registers.images)
        validate_texture(image, memory_size);
    validate_targets(registers.targets, memory_size);
    const unsigned factor = registers.primitive.line_stipple_factor;
    require(factor >= 1 && factor <= 256, "line_stipple_factor is not 1 to 256");
}

void validate(const DrawCommand& draw, const Registers& registers, std::uint64_t memory_size) {
    validate_enumerators(draw);
    require(
        lies_within(draw.vertex_address, vertex_bytes(draw, registers.vertex_format), memory_size),
        "the vertices do not lie in device memory");
    require(draw.vertex_count > 0 || draw.count == 0, "a draw without vertices in memory");
    if (draw.index_type == IndexType::None)
        require(std::uint64_t{draw.first} + draw.count <= draw.vertex_count,
                "the vertices drawn exceed those in memory");
    else
        require(lies_within(draw.index_address, index_bytes(draw), memory_size),
                "the indices do not lie in device memory");
    if (draw.output == DrawOutput::Feedback)
        require(feedback_fits(draw, memory_size),
                "the feedback buffer does not lie in device memory");
}

void validate(const DrawImageCommand& image, std::uint64_t memory_size) {
    validate_enumerators(image);
    require(is_image_format(image.format), "an image's format is not one of images");
    require(image.width <= MaxImageSize && image.height <= MaxImageSize,
            "an image exceeds the largest");
    require(image_fits(image, memory_size), "an image does not lie in device memory");
}

void validate(const CopyRectangleCommand& copy, std::uint64_t memory_size) {
    validate_enumerators(copy);
    for (const Surface* surface : {&copy.source, &copy.destination})
        require(surface_fits(*surface, memory_size), "a surface does not lie in device memory");
    require(copy.source_x + copy.width <= copy.source.width &&
                copy.source_y + copy.height <= copy.source.height &&
                copy.destination_x + copy.width <= copy.destination.width &&
                copy.destination_y + copy.height <= copy.destination.height,
            "a rectangle leaves its surface");
    if (copy.pictures == 1) return;
    require(copy.pictures >= 1 && copy.pictures <= MaxPictures,
            "a copy averages a number of pictures that no device averages");
    require(copy.source.samples == 1 && copy.destination.samples == 1 &&
                is_plain_color(copy.source.format) && is_plain_color(copy.destination.format),
            "a copy averages what are no single-sampled colours");
    require(copy.source.address + copy.source_bytes() <= memory_size,
            "a surface does not lie in device memory");
}

void validate(const StoreSampleCounterCommand& store, std::uint64_t memory_size) {
    require(lies_within(store.address, sizeof(std::uint64_t), memory_size),
            "the sample counter's place is outside device memory");
}

void validate_picture(const Surface& picture, std::uint64_t memory_size) {
    if (picture.format == Format::None || picture.width == 0 || picture.height == 0) return;
    require(surface_fits(picture, memory_size), "the picture does not lie in device memory");
}

} // namespace ffgpu
