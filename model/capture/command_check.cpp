#include "model/capture/command_check.h"

#include "model/device/enumerators.h"

namespace ffgpu::capture {
namespace {

template <class Packed>
std::string check_values(const Packed& packed) {
    const char* const field = find_bad_enumerator(packed);
    return field ? std::string("field ") + field + " holds no value of its kind" : std::string();
}

constexpr const char* Outside = " lies outside of the device's memory";

} // namespace

std::string CommandCheck::find_mistake(std::span<const std::uint32_t> words) {
    while (!words.empty()) {
        const std::size_t count = words[0] & 0xffffff;
        const auto opcode = static_cast<Opcode>(words[0] >> 24);
        if (count > words.size() - 1) return "a command does not end in its stream";
        if (std::string mistake = check_command(opcode, words.subspan(1, count)); !mistake.empty())
            return mistake;
        words = words.subspan(1 + count);
    }
    return {};
}

std::string CommandCheck::check_command(Opcode opcode, std::span<const std::uint32_t> payload) {
    const auto check_packed = [&]<class Command>(Command) -> std::string {
        if (payload.size() != WordCount<Command>) return "a command has a wrong number of words";
        const auto command = unpack<Command>(payload);
        std::string mistake = check_values(command);
        if constexpr (!std::is_same_v<Command, ClearCommand>) {
            if (mistake.empty()) mistake = check(command);
        }
        return mistake;
    };
    switch (opcode) {
    case Opcode::WriteRegister:
        return check_register(payload);
    case Opcode::Draw:
        return check_packed(DrawCommand{});
    case Opcode::Clear:
        return check_packed(ClearCommand{});
    case Opcode::DrawImage:
        return check_packed(DrawImageCommand{});
    case Opcode::CopyRectangle:
        return check_packed(CopyRectangleCommand{});
    case Opcode::ResetSampleCounter:
    case Opcode::EndFrame:
        return payload.empty() ? "" : "a command has a wrong number of words";
    case Opcode::StoreSampleCounter:
        if (payload.size() != 1) return "a command has a wrong number of words";
        return is_inside(payload[0], 8) ? "" : std::string("the sample counter's place") + Outside;
    }
    return "expected a command, found opcode " + std::to_string(static_cast<unsigned>(opcode));
}

std::string CommandCheck::check_register(std::span<const std::uint32_t> payload) {
    if (payload.empty() || payload[0] >= RegisterCount)
        return "expected a register below " + std::to_string(RegisterCount);
    std::string mistake;
    std::uint32_t address = 0;
    static const Registers map{};
    Registers::visit(map, [&](const auto& at_address) {
        using Register = std::remove_cvref_t<decltype(at_address)>;
        if (address++ != payload[0]) return;
        if (payload.size() != 1 + WordCount<Register>) {
            mistake = "a register has a wrong number of words";
            return;
        }
        const auto value = unpack<Register>(payload.subspan(1));
        mistake = check_values(value);
        if constexpr (requires { check(value); }) {
            if (mistake.empty()) mistake = check(value);
        }
    });
    return mistake;
}

std::string CommandCheck::check(const VertexFormat& format) {
    for (const VertexElement& element : format.elements)
        if (element.components > 4 || element.offset + element.components > format.stride)
            return "a vertex element is larger than its vertex";
    vertex_words_ = format.stride;
    return {};
}

std::string CommandCheck::check(const TextureImage& image) const {
    const TextureShape& shape = image.shape;
    if (shape.kind == TextureKind::None) return {};
    if (shape.width == 0 || shape.height == 0 || shape.depth == 0)
        return "a texture image is empty";
    if (shape.levels == 0 || shape.levels > MaxTextureLevels)
        return "expected 1 to " + std::to_string(MaxTextureLevels) + " levels of a texture";
    if (shape.width > MaxTextureSize || shape.height > MaxTextureSize ||
        shape.depth > MaxTexture3dSize)
        return "a texture image is too large";
    if (shape.format == Format::None || shape.format >= Format::Stencil8)
        return "a texture image has no format of texels";
    if (!is_inside(image.address, texture_bytes(shape))) return std::string("a texture") + Outside;
    return {};
}

std::string CommandCheck::find_mistake(const Surface& surface) const {
    if (surface.format == Format::None) return {};
    if (surface.format >= Format::Stencil8 || format_info(surface.format).block_width != 1)
        return "a surface has no format of pixels";
    if (surface.width > MaxSurfaceSize || surface.height > MaxSurfaceSize)
        return "a surface is too large";
    if (surface.stride < row_bytes(surface.format, surface.width))
        return "a surface's rows overlap";
    if (surface.samples != 1 && surface.samples != MaxSamples)
        return "a surface has a number of samples that no surface has";
    if (!is_inside(surface.address, surface.bytes())) return std::string("a surface") + Outside;
    return {};
}

std::string CommandCheck::check(const Targets& targets) const {
    std::string mistake;
    Targets::for_each(targets, [&](const Surface& surface) {
        if (mistake.empty()) mistake = find_mistake(surface);
    });
    return mistake;
}

std::string CommandCheck::check(const DrawCommand& draw) const {
    const std::uint64_t index_bytes = draw.index_type == IndexType::None  ? 0
                                      : draw.index_type == IndexType::U16 ? 2
                                                                          : 4;
    if (!is_inside(draw.vertex_address, std::uint64_t{4} * vertex_words_ * draw.vertex_count))
        return std::string("a draw's vertices") + Outside;
    if (!is_inside(draw.index_address, index_bytes * draw.count))
        return std::string("a draw's indices") + Outside;
    if (index_bytes == 0 && std::uint64_t{draw.first} + draw.count > draw.vertex_count)
        return "a draw has more vertices than its memory";
    if (draw.output == DrawOutput::Feedback &&
        !is_inside(draw.feedback_address, std::uint64_t{4} + draw.feedback_bytes))
        return std::string("a draw's feedback") + Outside;
    return {};
}

std::string CommandCheck::check(const DrawImageCommand& image) const {
    constexpr std::uint32_t Most = 1 << 24; // So that a row's bytes fit 32 bits.
    if (image.width > Most || image.height > Most) return "an image is too large";
    if (image.height == 0 || image.width == 0) return {};
    if (image.format == Format::None) return "an image has no format";
    const std::uint64_t bytes =
        std::uint64_t{image.stride} * (image.height - 1) + row_bytes(image.format, image.width);
    return is_inside(image.address, bytes) ? "" : std::string("an image") + Outside;
}

std::string CommandCheck::check(const CopyRectangleCommand& copy) const {
    for (const Surface* surface : {&copy.source, &copy.destination})
        if (std::string mistake = find_mistake(*surface); !mistake.empty()) return mistake;
    if (copy.source_x + copy.width > copy.source.width ||
        copy.source_y + copy.height > copy.source.height ||
        copy.destination_x + copy.width > copy.destination.width ||
        copy.destination_y + copy.height > copy.destination.height)
        return "a copy's rectangle is larger than its surface";
    return {};
}

} // namespace ffgpu::capture
