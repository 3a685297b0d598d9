// A device between a driver and its GPU that draws with RTL as well, and compares.

#pragma once

#include "model/gpu/functional_gpu.h"

#include <cstdint>
#include <string>

namespace ffgpu::tools {

class RtlDevice : public Device {
public:
    // From now on to be drawn on instead of `device`, which draws on `gpu`.
    virtual void attach(Device& device, FunctionalGpu& gpu) = 0;
    virtual void number_draws_from(std::uint32_t draw) = 0;

    virtual bool equal() const = 0;
    // Lines for people.
    virtual std::string summary() const = 0;
    // What it writes itself has its name. Throws InputError.
    virtual void commit() {}
};

} // namespace ffgpu::tools
