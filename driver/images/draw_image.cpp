#include "driver/images/draw_image.h"

#include "driver/device_context/device_context.h"
#include "driver/objects/device_block.h"
#include "driver/objects/shared_objects.h"

#include <tuple>

namespace ffgpu::gl {

void draw_image(DeviceContext& context, const HostImage& image, const ImagePlace& place) {
    if (image.pixels.empty() || !context.prepare_draw()) return;
    // Memory and commands act in order: the block is free again once the draw is submitted.
    const DeviceBlock staged = DeviceBlock::allocate(context.shared().memory, image.pixels.size());
    if (!staged) return context.error(GL_OUT_OF_MEMORY);
    context.device().write_memory(staged.address(), image.pixels);

    const RasterPosition& raster = context.state.current.raster;
    CommandStream commands;
    commands.add(DrawImageCommand{.format = image.format,
                                  .address = staged.address(),
                                  .stride = row_bytes(image.format, image.width),
                                  .width = image.width,
                                  .height = image.height,
                                  .x = place.x,
                                  .y = place.y,
                                  .zoom_x = place.zoom_x,
                                  .zoom_y = place.zoom_y,
                                  .depth = raster.position[2],
                                  .fog_coordinate = raster.distance,
                                  .color = raster.color,
                                  .secondary_color = raster.secondary_color,
                                  .tex_coords = raster.tex_coords});
    context.submit_drawing(commands);
}

void draw_depths_untested(DeviceContext& context, const HostImage& image, const ImagePlace& place) {
    FragmentState& fragment = context.state.fragment;
    auto& color_mask = context.state.framebuffer.color_mask;
    const auto kept =
        std::tuple(fragment.alpha_test.enable, fragment.stencil.enable, fragment.depth, color_mask);
    fragment.alpha_test.enable = fragment.stencil.enable = fragment.depth.bounds_test = false;
    fragment.depth.enable = true;
    fragment.depth.func = GL_ALWAYS;
    color_mask = {};
    context.dirty.mark(Dirty::Fragment);
    draw_image(context, image, place);
    std::tie(fragment.alpha_test.enable, fragment.stencil.enable, fragment.depth, color_mask) =
        kept;
    context.dirty.mark(Dirty::Fragment);
}

} // namespace ffgpu::gl
