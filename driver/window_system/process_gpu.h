// ProcessGpu: the one GPU of a process that uses a drop-in library, and the lock around it.
//
// Contexts of several threads may be current at once (GLX 1.4, 2.5); their calls take turns on the
// device.

#pragma once

#include "driver/memory_allocator.h"
#include "model/gpu/functional_gpu.h"

#include <memory>
#include <mutex>

namespace ffgpu::gl {

class Context;

class ProcessGpu {
public:
    // Made at the first call. FFGPU_THREADS: how many threads draw (default: one).
    static ProcessGpu& instance();

    Device& device() { return *device_; }
    FunctionalGpu& gpu() { return *gpu_; }
    const std::shared_ptr<MemoryAllocator>& memory() const { return memory_; }

    // Puts a device in front of the GPU that sees everything first (a capture writer). Before the
    // first context is made.
    void interpose(std::unique_ptr<Device> device);

    // Held during each call of OpenGL or of the window system.
    class Turn {
    public:
        explicit Turn(ProcessGpu& gpu = instance());
        ~Turn();
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        ProcessGpu& gpu_;
    };

private:
    ProcessGpu();

    void change_owner(Context* context);

    std::unique_ptr<FunctionalGpu> gpu_;
    std::unique_ptr<Device> interposed_;
    Device* device_;
    std::shared_ptr<MemoryAllocator> memory_;
    std::recursive_mutex mutex_;
    Context* owner_ = nullptr; // whose registers the device holds
};

} // namespace ffgpu::gl
