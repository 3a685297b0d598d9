#include "driver/window_system/process_gpu.h"

#include "driver/window_system/run_mark.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string_view>
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

std::string_view setting(const char* variable) {
    const char* const text = std::getenv(variable);
    return text ? text : "";
}

std::unique_ptr<Device> make_gpu() {
    return std::make_unique<FunctionalGpu>(FunctionalGpu::Config{.threads = thread_count()});
}

// A recorder that cannot start ends the process: by then `ffgpu run` knows that it draws.
std::unique_ptr<Recorder> announce_and_open_recorder() {
    RunMark::leave();
    return open_recorder();
}

} // namespace

ProcessGpu& ProcessGpu::instance() {
    static ProcessGpu* const gpu = new ProcessGpu; // Lives on: atexit handlers may still draw.
    return *gpu;
}

ProcessGpu::ProcessGpu()
    : recorder_(announce_and_open_recorder())
    , gpu_(recorder_ ? nullptr : make_gpu())
    , device_(recorder_ ? &recorder_->device() : gpu_.get())
    , memory_(std::make_shared<MemoryAllocator>(0, device_->memory_size())) {}

ControlPanel ProcessGpu::control_panel() {
    ControlPanel panel;
    const auto& names = ForcedFilterNames;
    const auto named = std::find(names.begin(), names.end(), setting("FFGPU_TEXTURE_FILTER"));
    if (named != names.end())
        panel.texture_filter = static_cast<ForcedFilter>(named - names.begin());
    const std::string_view text = setting("FFGPU_SUPERSAMPLING");
    std::uint32_t pictures = 1;
    std::from_chars(text.data(), text.data() + text.size(), pictures);
    if (std::has_single_bit(pictures) && pictures <= MaxSupersampling)
        panel.supersampling = pictures;
    return panel;
}

std::shared_ptr<SharedObjects> ProcessGpu::make_shared_objects() const {
    return std::make_shared<SharedObjects>(memory_, control_panel());
}

void ProcessGpu::frame_shown(const Surface& picture) {
    CommandStream commands;
    commands.add(Opcode::EndFrame);
    device_->submit(commands);
    if (!recorder_) return;
    if (!std::exchange(has_frame_, true)) RunMark::leave_frame();
    recorder_->frame_shown(picture); // It may be the last.
}

void ProcessGpu::read_picture(DeviceAddress at, std::span<std::byte> bytes) {
    if (recorder_)
        recorder_->read_picture(at, bytes);
    else
        device_->read_memory(at, bytes);
}

} // namespace ffgpu::gl
