// What draws a side of a diff: stages by their name.

#pragma once

#include "model/gpu/stages.h"
#include "rtl/loop/rtl_stages.h"

#include <memory>
#include <string>

namespace ffgpu::tools {

class Backend {
public:
    // "functional", "reference"; "rtl": all Verilated units in the model's stages, "rtl:fog,blend":
    // these. Throws InputError where there is no such thing.
    // `waves`: a folder for those of the units; empty: none.
    explicit Backend(const std::string& name,
                     const std::string& waves = {},
                     rtl::WaveCycles wave_cycles = {});

    const Stages& stages() const { return *stages_; }
    // Null: no unit is Verilated.
    rtl::RtlStages* rtl() const { return rtl_.get(); }

private:
    std::unique_ptr<rtl::RtlStages> rtl_;
    const Stages* stages_ = nullptr;
};

} // namespace ffgpu::tools
