// ViewDevice: a Device that passes all calls on, and has the pictures of views: it draws the
// redrawn ones on devices of their own, and knows which depth target belongs to a colour target.

#pragma once

#include "model/device/device.h"
#include "model/device/register_file.h"
#include "model/gpu/functional_gpu.h"
#include "tools/image/image.h"
#include "tools/views/view.h"

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace ffgpu::tools {

class ViewDevice final : public Device {
public:
    // `config`: of the devices of redrawn views.
    ViewDevice(Device& device, const std::set<View>& views, const FunctionalGpu::Config& config);
    ~ViewDevice() override;

    // Of the frame that ended with `shown`; black where there is none. `gpu` is the device itself,
    // behind all that records what is read of it.
    Image picture(View view, const Surface& shown, Device& gpu);

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override { device_.finish(); }
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    class Redrawn;

    const Surface* depth_target(const Surface& shown) const;

    Device& device_;
    RegisterFile registers_;
    std::map<DeviceAddress, Surface> depth_of_; // the last used with each colour target
    Surface last_depth_;
    std::vector<std::unique_ptr<Redrawn>> redrawn_;
};

} // namespace ffgpu::tools
