#include "driver/window_system/process_gpu.h"

#include "driver/window_system/run_mark.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

namespace ffgpu::gl {
namespace {

constexpr unsigned MaxThreads = 64;

// FFGPU_THREADS, or one a processor of the host. No picture depends on it.
unsigned thread_count() {
    unsigned threads = std::thread::hardware_concurrency();
    if (const char* const text = std::getenv("FFGPU_THREADS"))
        std::from_chars(text, text + std::strlen(text), threads);
    return std::clamp(threads, 1u, MaxThreads);
}

std::unique_ptr<Device> make_gpu() {
    return std::make_unique<FunctionalGpu>(FunctionalGpu::Config{.threads = thread_count()});
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
    , memory_(std::make_shared<MemoryAllocator>(0, device_->memory_size())) {
    RunMark::leave();
}

void ProcessGpu::frame_shown(const Surface& picture) {
    CommandStream commands;
    commands.add(Opcode::EndFrame);
    device_->submit(commands);
    if (!recorder_) return;
    if (!std::exchange(has_frame_, true)) RunMark::leave_frame();
    recorder_->frame_shown(picture); // It may be the last.
}

} // namespace ffgpu::gl
