#include "driver/texture/residency.h"

#include "model/base/check.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace ffgpu::gl {

namespace {

// Strides of an image's stored texels: the same on the host and on the device.
struct ImageStrides {
    std::size_t row, layer;
    std::uint32_t rows; // of blocks, in a layer

    ImageStrides(Format format, const TexelBox& box)
        : row(row_bytes(format, box.width))
        , layer(row * block_rows(format, box.height))
        , rows(block_rows(format, box.height)) {}
};

// Where the image is on the device; nothing: the host has it.
std::optional<std::uint64_t> image_address(const TextureObject& texture, ImageName name) {
    const TextureLevel& image = texture.level(name.face, name.level);
    if (image.block) return image.block->address();
    if (!image.resident) return std::nullopt;
    const auto& resident = texture.resident;
    const LevelLayout layout = level_layout(resident.shape, name.level - resident.root);
    return resident.block.address() + layout.offset +
           std::uint64_t{name.face} * layout.layer_stride;
}

// Calls visitor(offset in the image, offset in the part, bytes) for each contiguous run.
template <class Visitor>
void for_each_run(Format format, const TexelBox& image, const TexelBox& box, Visitor&& visitor) {
    const FormatInfo& info = format_info(format);
    const ImageStrides whole(format, image), part(format, box);
    const std::size_t x = std::size_t{box.x} / info.block_width * info.block_bytes;
    const std::size_t y = box.y / info.block_height;
    const bool full_rows = part.row == whole.row;
    const bool full_layers = full_rows && part.rows == whole.rows;
    if (full_layers) return visitor(box.z * whole.layer, 0, part.layer * box.depth);
    for (std::size_t z = 0; z < box.depth; ++z) {
        const std::size_t layer = (box.z + z) * whole.layer;
        if (full_rows) {
            visitor(layer + y * whole.row, z * part.layer, part.layer);
            continue;
        }
        for (std::size_t row = 0; row < part.rows; ++row) {
            visitor(layer + (y + row) * whole.row + x, z * part.layer + row * part.row, part.row);
        }
    }
}

bool same_definition(const TextureLevel& a, const TextureLevel& b) {
    return a.format.format == b.format.format && a.width == b.width && a.height == b.height &&
           a.depth == b.depth && a.border == b.border;
}

// The block that the texture has can hold the chain as it is.
bool holds(const TextureObject::Resident& resident, const TextureChain& chain) {
    TextureShape shape = chain.shape;
    shape.levels = resident.shape.levels;
    return resident.block && resident.root == chain.root && resident.shape == shape &&
           resident.shape.levels >= chain.shape.levels;
}

void evacuate(DeviceMemory memory, TextureObject& texture) {
    for (unsigned face = 0; face < texture.faces(); ++face) {
        for (unsigned level = 0; level < MaxTextureLevels; ++level) {
            TextureLevel& image = texture.level(face, level);
            if (!image.resident) continue;
            image.texels = read_texels(memory, texture, {face, level}, whole_box(image));
            image.resident = false;
        }
    }
    texture.resident = {};
}

} // namespace

std::size_t box_bytes(Format format, const TexelBox& box) {
    return ImageStrides(format, box).layer * box.depth;
}

TexelBox whole_box(const TextureLevel& image) {
    return {.width = static_cast<std::uint32_t>(image.width),
            .height = static_cast<std::uint32_t>(image.height),
            .depth = static_cast<std::uint32_t>(image.depth)};
}

void define_image(DeviceMemory memory,
                  TextureObject& texture,
                  ImageName name,
                  TextureLevel definition,
                  std::vector<std::byte> texels) {
    TextureLevel& image = texture.level(name.face, name.level);
    const bool stays = same_definition(image, definition);
    if (image.internal_format != definition.internal_format || !stays) texture.changed();
    if (stays && (image.resident || image.block)) {
        image.internal_format = definition.internal_format;
        image.format = definition.format;
        if (!texels.empty()) write_texels(memory, texture, name, whole_box(image), texels);
        return;
    }
    image = std::move(definition);
    image.resident = false;
    image.texels = std::move(texels);
    image.texels.resize(box_bytes(image.format.format, whole_box(image)));
    texture.changed();
}

void write_texels(DeviceMemory memory,
                  TextureObject& texture,
                  ImageName name,
                  const TexelBox& box,
                  std::span<const std::byte> texels) {
    TextureLevel& image = texture.level(name.face, name.level);
    const Format format = image.format.format;
    texture.filter_table.current = false;
    check(texels.size() >= box_bytes(format, box), "too few texels for the part of the image");
    const std::optional<std::uint64_t> address = image_address(texture, name);
    for_each_run(
        format, whole_box(image), box, [&](std::size_t at, std::size_t from, std::size_t bytes) {
            const auto run = texels.subspan(from, bytes);
            if (run.empty()) return;
            if (address) {
                memory.device.write_memory(static_cast<DeviceAddress>(*address + at), run);
            } else {
                std::memcpy(image.texels.data() + at, run.data(), bytes);
            }
        });
}

std::vector<std::byte> read_texels(DeviceMemory memory,
                                   const TextureObject& texture,
                                   ImageName name,
                                   const TexelBox& box) {
    const TextureLevel& image = texture.level(name.face, name.level);
    const Format format = image.format.format;
    std::vector<std::byte> texels(box_bytes(format, box));
    const std::optional<std::uint64_t> address = image_address(texture, name);
    for_each_run(
        format, whole_box(image), box, [&](std::size_t at, std::size_t to, std::size_t bytes) {
            const auto run = std::span(texels).subspan(to, bytes);
            if (run.empty()) return;
            if (address) {
                memory.device.read_memory(static_cast<DeviceAddress>(*address + at), run);
            } else {
                std::memcpy(run.data(), image.texels.data() + at, bytes);
            }
        });
    return texels;
}

namespace {

// The texels of an image outside of the object's block, which then has none.
std::vector<std::byte> take_texels(DeviceMemory memory, TextureObject& texture, ImageName name) {
    TextureLevel& image = texture.level(name.face, name.level);
    std::vector<std::byte> texels = image.block
                                        ? read_texels(memory, texture, name, whole_box(image))
                                        : std::move(image.texels);
    image.block = nullptr;
    image.texels = {};
    return texels;
}

// Device memory of its own for an image that is not in the chain. False: there is no room.
bool give_block(DeviceMemory memory, TextureObject& texture, ImageName name) {
    TextureLevel& image = texture.level(name.face, name.level);
    if (image.block) return true;
    const std::size_t bytes = box_bytes(image.format.format, whole_box(image));
    DeviceBlock block = DeviceBlock::allocate(memory.allocator, bytes);
    if (!block) return false;
    const std::vector<std::byte> texels = take_texels(memory, texture, name);
    image.block = std::make_shared<DeviceBlock>(std::move(block));
    write_texels(memory, texture, name, whole_box(image), texels);
    return true;
}

} // namespace

bool make_resident(DeviceMemory memory, TextureObject& texture) {
    const TextureChain& chain = texture.chain();
    if (chain.shape.kind == TextureKind::None) return false;
    if (texture.resident_is_current()) return true;
    if (!holds(texture.resident, chain)) {
        evacuate(memory, texture);
        DeviceBlock block = DeviceBlock::allocate(memory.allocator, texture_bytes(chain.shape));
        if (!block) return false;
        texture.resident = {std::move(block), chain.shape, chain.root};
    }
    for (unsigned face = 0; face < texture.faces(); ++face) {
        for (unsigned level = chain.root; level < chain.root + chain.shape.levels; ++level) {
            TextureLevel& image = texture.level(face, level);
            if (image.resident || !image.defined()) continue;
            const std::vector<std::byte> texels = take_texels(memory, texture, {face, level});
            image.resident = true;
            write_texels(memory, texture, {face, level}, whole_box(image), texels);
        }
    }
    texture.note_resident();
    return true;
}

Surface image_memory(DeviceMemory memory, TextureObject& texture, ImageName name, unsigned layer) {
    const TextureLevel& image = texture.level(name.face, name.level);
    if (!image.defined()) return {};
    make_resident(memory, texture);
    texture.filter_table.current = false;
    texture.note_drawing();
    if (!image.resident && !give_block(memory, texture, name)) return {};
    const ImageStrides strides(image.format.format, whole_box(image));
    return {.address =
                static_cast<DeviceAddress>(*image_address(texture, name) + layer * strides.layer),
            .format = image.format.format,
            .width = static_cast<std::uint16_t>(image.width),
            .height = static_cast<std::uint16_t>(image.height),
            .stride = static_cast<std::uint32_t>(strides.row)};
}

Surface image_surface(DeviceMemory memory, TextureObject& texture, ImageName name, unsigned layer) {
    const TextureLevel& image = texture.level(name.face, name.level);
    if (image.border != 0 || !is_renderable(image.format.format)) return {};
    return image_memory(memory, texture, name, layer);
}

} // namespace ffgpu::gl
