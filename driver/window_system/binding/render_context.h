// RenderContext: a GL context as GLX and EGL hand it out, with the group it shares objects with.

#pragma once

#include "driver/context/context.h"
#include "driver/objects/shared_objects.h"
#include "driver/window_system/process_gpu.h"

#include <memory>

namespace ffgpu::gl {

struct RenderContext {
    // `share`: null, or the context to share objects with.
    explicit RenderContext(const RenderContext* share)
        : shared(share ? share->shared : ProcessGpu::instance().make_shared_objects())
        , context(ProcessGpu::instance().device(), shared) {}

    std::shared_ptr<SharedObjects> shared;
    Context context;
    bool bound = false; // in some thread
};

} // namespace ffgpu::gl
