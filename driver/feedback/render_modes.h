// RenderModes: where primitives go (glRenderMode): to the picture, to hit records or to the
// feedback buffer. In the last two the device transforms, clips and culls as ever, and records what
// it would have rasterized.

#pragma once

#include "driver/feedback/feedback.h"
#include "driver/feedback/selection.h"
#include "driver/objects/device_block.h"

#include <span>
#include <vector>

namespace ffgpu::gl {

class DeviceContext;

class RenderModes {
public:
    explicit RenderModes(DeviceContext& context)
        : context_(context) {}

    GLenum mode() const { return mode_; }
    // What glRenderMode returns: the result of the mode that ends.
    GLint change_mode(GLenum mode);

    // Selection and feedback: carries out draws whose registers have been noted.
    void draw(std::span<DrawCommand> draws);

    // A valid raster position was set, or a pixel rectangle is drawn there (`token`:
    // GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN, GL_COPY_PIXEL_TOKEN). The second returns false in
    // GL_RENDER mode: the pixels are to be drawn.
    void raster_position_set();
    bool takes_pixels(GLenum token);

    Selection selection;
    Feedback feedback;

private:
    bool run(DrawCommand draw);
    void read_records(std::span<const std::uint32_t> words);

    DeviceContext& context_;
    GLenum mode_ = GL_RENDER;
    DeviceBlock records_;
    std::vector<std::uint32_t> words_;
    std::vector<FeedbackVertex> vertices_;
};

} // namespace ffgpu::gl
