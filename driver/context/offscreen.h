// OffscreenContext: a context with a drawable of its own on a given device, for tests, the trace
// player and programs without a window system.

#pragma once

#include "driver/context/context.h"
#include "driver/context/current.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/shared_objects.h"

#include <memory>

namespace ffgpu::gl {

class OffscreenContext {
public:
    struct Options {
        unsigned width = 1, height = 1;
        PixelFormat format{};
        std::shared_ptr<SharedObjects> shared{}; // null: objects of its own
    };

    // The drawable may still be resized. Throws std::bad_alloc if device memory is full.
    OffscreenContext(Device& device, Options options)
        : shared_(options.shared ? std::move(options.shared)
                                 : std::make_shared<SharedObjects>(device))
        , drawable_(device, *shared_->memory, options.format, options.width, options.height)
        , context_(device, shared_) {}

    // A context must not stay current beyond its life.
    ~OffscreenContext() {
        if (current_context() == &context_) gl::make_current(nullptr, nullptr, nullptr);
    }
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    void make_current() { gl::make_current(&context_, &drawable_, &drawable_); }

    Context& context() { return context_; }
    Drawable& drawable() { return drawable_; }
    const std::shared_ptr<SharedObjects>& shared() const { return shared_; }

private:
    std::shared_ptr<SharedObjects> shared_;
    Drawable drawable_;
    Context context_;
};

} // namespace ffgpu::gl
