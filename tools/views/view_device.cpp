#include "tools/views/view_device.h"

#include "tools/report/frame_image.h"
#include "tools/views/depth_picture.h"

#include <algorithm>

namespace ffgpu::tools {

// A device that draws the commands with a view's registers. Its own texture lies behind the memory
// that the program knows.
class ViewDevice::Redrawn {
public:
    Redrawn(View view, FunctionalGpu::Config config, std::uint64_t memory_bytes)
        : view_(view)
        , texture_(static_cast<DeviceAddress>(memory_bytes))
        , gpu_(with_memory(config, memory_bytes)) {
        gpu_.write_memory(texture_, view_texture());
    }

    View view() const { return view_; }
    FunctionalGpu& gpu() { return gpu_; }

    void submit(const CommandReader& reader, const Registers& registers) {
        CommandStream stream;
        const Registers wanted = view_registers(view_, registers, texture_);
        write_changes(sent_, wanted, stream);
        sent_ = wanted;
        if (reader.opcode() == Opcode::Clear && info(view_).source == ViewSource::RedrawnOnBlack) {
            auto clear = reader.command<ClearCommand>();
            clear.color_value = 0;
            stream.add(clear);
        } else {
            stream.words.insert(stream.words.end(), reader.whole().begin(), reader.whole().end());
        }
        gpu_.submit(stream);
    }

private:
    static FunctionalGpu::Config with_memory(FunctionalGpu::Config config, std::uint64_t bytes) {
        config.memory_bytes = bytes + 4 * ViewTextureSize * ViewTextureSize;
        return config;
    }

    const View view_;
    const DeviceAddress texture_;
    FunctionalGpu gpu_;
    Registers sent_;
};

ViewDevice::ViewDevice(Device& device,
                       const std::set<View>& views,
                       const FunctionalGpu::Config& config)
    : device_(device) {
    for (const View view : views)
        if (info(view).source != ViewSource::Target)
            redrawn_.push_back(std::make_unique<Redrawn>(view, config, device.memory_size()));
}

ViewDevice::~ViewDevice() = default;

void ViewDevice::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    device_.write_memory(at, bytes);
    for (const auto& view : redrawn_)
        view->gpu().write_memory(at, bytes);
}

// What the program reads is what it would read without views.
void ViewDevice::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    device_.read_memory(at, bytes);
}

void ViewDevice::submit(const CommandStream& commands) {
    device_.submit(commands); // What it refuses nobody draws.
    for_each_command(commands.words, [this](const CommandReader& reader) {
        if (reader.opcode() == Opcode::WriteRegister) {
            registers_.write(reader.register_write());
            return;
        }
        const Targets& targets = registers_.values().targets;
        if (targets.depth.format != Format::None)
            depth_of_[targets.color[0].address] = last_depth_ = targets.depth;
        for (const auto& view : redrawn_)
            view->submit(reader, registers_.values());
    });
}

// What is shown may be another surface than the one that was drawn to: of multisampled windows it
// is what their samples were resolved to.
const Surface* ViewDevice::depth_target(const Surface& shown) const {
    const auto found = depth_of_.find(shown.address);
    const Surface& depth = found == depth_of_.end() ? last_depth_ : found->second;
    return depth.width == shown.width && depth.height == shown.height ? &depth : nullptr;
}

Image ViewDevice::picture(View view, const Surface& shown, Device& gpu) {
    if (info(view).source != ViewSource::Target) {
        const auto found = std::ranges::find(redrawn_, view, &Redrawn::view);
        return read_surface((*found)->gpu(), shown);
    }
    const Surface* const depth = depth_target(shown);
    if (!depth) return {shown.width, shown.height};
    return view == View::Depth ? depth_picture(gpu, *depth) : stencil_picture(gpu, *depth);
}

} // namespace ffgpu::tools
