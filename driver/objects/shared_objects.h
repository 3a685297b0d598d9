// SharedObjects: what the contexts of one share group have in common (glXCreateContext's share
// list), and the allocator of the device's memory.

#pragma once

#include "driver/memory_allocator.h"
#include "driver/objects/control_panel.h"
#include "driver/objects/name_table.h"
#include "model/device/device.h"

#include <memory>
#include <utility>

namespace ffgpu::gl {

class BufferObject;  // driver/objects/buffer_object.h
struct DisplayList;  // driver/lists/
class TextureObject; // driver/objects/texture_object.h
struct Renderbuffer;
struct FramebufferObject;

struct SharedObjects {
    // All of the device's memory for this group alone.
    explicit SharedObjects(Device& device)
        : SharedObjects(std::make_shared<MemoryAllocator>(0, device.memory_size())) {}

    // For groups that share no objects but draw on the same device.
    explicit SharedObjects(std::shared_ptr<MemoryAllocator> device_memory,
                           const ControlPanel& panel = {})
        : memory(std::move(device_memory))
        , control_panel(panel) {}

    std::shared_ptr<MemoryAllocator> memory;
    const ControlPanel control_panel;
    NameTable<TextureObject> textures;
    NameTable<BufferObject> buffers;
    NameTable<DisplayList> lists;
    NameTable<Renderbuffer> renderbuffers;
    NameTable<FramebufferObject> framebuffers; // Shared as in EXT_framebuffer_object.
};

} // namespace ffgpu::gl
