#include "driver/window_system/process_gpu.h"

#include "driver/context/context.h"
#include "driver/context/current.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace ffgpu::gl {
namespace {

unsigned threads_from_environment() {
    const char* const text = std::getenv("FFGPU_THREADS");
    unsigned threads = 1;
    if (text) std::from_chars(text, text + std::strlen(text), threads);
    return std::clamp(threads, 1u, 64u);
}

} // namespace

ProcessGpu& ProcessGpu::instance() {
    static ProcessGpu* const gpu = new ProcessGpu; // Lives on: atexit handlers may still draw.
    return *gpu;
}

ProcessGpu::ProcessGpu()
    : gpu_(std::make_unique<FunctionalGpu>(
          FunctionalGpu::Config{.threads = threads_from_environment()}))
    , device_(gpu_.get())
    , memory_(std::make_shared<MemoryAllocator>(0, gpu_->memory_size())) {}

void ProcessGpu::interpose(std::unique_ptr<Device> device) {
    interposed_ = std::move(device);
    device_ = interposed_.get();
}

void ProcessGpu::change_owner(Context* context) {
    if (!context || context == owner_) return;
    // Another context's registers are in the device; a destroyed one's address may come again,
    // but then make_current has made its registers be sent.
    if (owner_) context->registers.forget();
    owner_ = context;
}

ProcessGpu::Turn::Turn(ProcessGpu& gpu)
    : gpu_(gpu) {
    gpu_.mutex_.lock();
    gpu_.change_owner(current_context());
}

ProcessGpu::Turn::~Turn() {
    gpu_.mutex_.unlock();
}

} // namespace ffgpu::gl
