#include "driver/window_system/process_gpu.h"

#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <thread>

namespace ffgpu::gl {
namespace {

std::unique_ptr<Device> make_gpu() {
    const unsigned processors = std::clamp(std::thread::hardware_concurrency(), 1u, 64u);
    return std::make_unique<FunctionalGpu>(FunctionalGpu::Config{.threads = processors});
}

} // namespace

ProcessGpu& ProcessGpu::instance() {
    static ProcessGpu* const gpu = new ProcessGpu; // Lives on: atexit handlers may still draw.
    return *gpu;
}

ProcessGpu::ProcessGpu()
    : recorder_(open_recorder())
    , gpu_(recorder_ ? nullptr : make_gpu())
    , device_(recorder_ ? &recorder_->device() : gpu_.get())
    , memory_(std::make_shared<MemoryAllocator>(0, device_->memory_size())) {}

void ProcessGpu::frame_shown(const Surface& picture) {
    CommandStream commands;
    commands.add(Opcode::EndFrame);
    device_->submit(commands);
    if (recorder_) recorder_->frame_shown(picture);
}

} // namespace ffgpu::gl
