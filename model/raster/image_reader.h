// ImageReader: the data of fragments from the pixels of an image in device memory.

#pragma once

#include "model/device/commands.h"
#include "model/memory/pixel_format.h"
#include "model/packets/draw_state.h"
#include "model/packets/fragment_batch.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

// The image must fit (model/device/extents.h).
class ImageReader {
public:
    ImageReader(const DrawImageCommand& image,
                const DrawState& state,
                std::span<const std::byte> memory);

    // Fills one lane from image pixel (i, j); false: no fragment there.
    bool read(FragmentBatch& batch, unsigned lane, std::uint32_t i, std::uint32_t j) const;

    // What every lane gets, covered or not.
    void fill_constants(FragmentBatch& batch) const;

private:
    const DrawImageCommand& image_;
    const std::byte* pixels_;
    Format depth_target_;

    // What all fragments share.
    PixelColor color_, secondary_;
    std::uint32_t depth_;
};

} // namespace ffgpu
