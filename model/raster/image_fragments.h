// Fragments of an image's pixels, for glDrawPixels and glBitmap (GL 1.5, 3.6.4, 3.6.5, 3.7).
//
// A fragment belongs to the image pixel whose zoomed rectangle holds its centre, the left and the
// lower edge included: with u = (x + 1/2 - x0) / zoom in binary64, column floor(u), and
// ceil(u) - 1 where zoom is negative. A zoom or a place that is zero or not finite makes nothing.
//
// Where primitives cover samples the rule holds for each sample, and a pixel makes a fragment of
// every image pixel that one of its samples lies in (3.6.6, 3.7).

#pragma once

#include "model/device/commands.h"
#include "model/packets/draw_state.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/rectangle.h"

#include <cstddef>
#include <functional>
#include <span>

namespace ffgpu {

using ImageBatchSink = std::function<void(FragmentBatch&)>;

// Hands over the fragments within `tile` (which is cut to the scissor) in batches of whole quads,
// rows of quads from the bottom, left to right: position, live, depth in the units of the depth
// target, fog coordinate, primary and secondary colour; front facing, primitive 0. The texture
// coordinates of each fragment are image.tex_coords: the sink samples with them. The batch's
// `samples` are filled where state.multisample is on. An image that leaves memory makes nothing,
// and so does Format::Stencil8.
void image_fragments(const DrawImageCommand& image,
                     const DrawState& state,
                     Rectangle tile,
                     std::span<const std::byte> memory,
                     const ImageBatchSink& sink);

// Writes a Stencil8 image into the stencil buffer of a Depth24Stencil8 target, under the front
// face's write mask, all samples of it. Other formats and targets do nothing.
void draw_stencil_image(const DrawImageCommand& image,
                        const Registers& registers,
                        Rectangle tile,
                        std::span<std::byte> memory);

// The pixels of `window` that the whole image covers, or a sample of them; empty where it makes
// nothing.
Rectangle image_bounds(const DrawImageCommand& image, Rectangle window, bool multisample);

} // namespace ffgpu
