// ProcessGpu: the one GPU of a process that uses a drop-in library.

#pragma once

#include "driver/memory_allocator.h"
#include "driver/objects/control_panel.h"
#include "driver/objects/shared_objects.h"
#include "driver/window_system/recorder.h"
#include "model/device/device.h"

#include <memory>

namespace ffgpu::gl {

class ProcessGpu {
public:
    // Made at the first call, in a Turn. It lives as long as the process.
    static ProcessGpu& instance();

    Device& device() { return *device_; }
    // Of the device's memory, for all contexts and drawables.
    const std::shared_ptr<MemoryAllocator>& memory() const { return memory_; }

    // Of the driver: the environment says it (FFGPU_TEXTURE_FILTER, FFGPU_SUPERSAMPLING).
    static ControlPanel control_panel();
    // For a group of contexts of its own.
    std::shared_ptr<SharedObjects> make_shared_objects() const;

    // A frame is done: `picture` is what a window shows from now on.
    void frame_shown(const Surface& picture);
    // Reads device memory for a window's picture: nothing that the program asked for.
    void read_picture(DeviceAddress at, std::span<std::byte> bytes);

private:
    ProcessGpu();

    std::unique_ptr<Recorder> recorder_; // or null
    bool has_frame_ = false;             // recorded
    std::unique_ptr<Device> gpu_;        // where there is no recorder
    Device* device_;
    std::shared_ptr<MemoryAllocator> memory_;
};

} // namespace ffgpu::gl
