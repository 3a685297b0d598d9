// Images in display lists: they are copied, without gaps, when the command is compiled, with the
// pixel-store state and the unpack buffer of that time (GL 1.5, 5.4).

#pragma once

#include "driver/lists/image_commands.h"
#include "driver/lists/record.h"
#include "driver/state/buffer_state.h"
#include "driver/state/pixel_store_state.h"

#include <memory>

namespace ffgpu::gl {

class DeviceContext;

// The pixel store that describes the copy, and the copy, into `record`. An image that GL would
// refuse becomes a null pointer: the command is refused when it is executed.
struct ImageCopy {
    PixelStore store;
    PixelLayout source;
    std::size_t row_bytes = 0;
    std::size_t rows = 0, images = 0;
    const std::byte* pixels = nullptr; // null: there is no image
};
ImageCopy plan_image_copy(DeviceContext& context, const ImageArguments& image, const void* pixels);
void record_image(RecordWriter& record, const ImageCopy& copy);

// `bytes` at `data`, an offset where an unpack buffer is bound; null if they do not lie in it.
const std::byte* unpack_source(DeviceContext& context, const void* data, std::size_t bytes);

// While a recorded command is executed, images lie as the record says, in no buffer.
class RecordedUnpack {
public:
    RecordedUnpack(DeviceContext& context, const PixelStore& store);
    ~RecordedUnpack();
    RecordedUnpack(const RecordedUnpack&) = delete;
    RecordedUnpack& operator=(const RecordedUnpack&) = delete;

private:
    DeviceContext& context_;
    PixelStore store_;
    std::shared_ptr<BufferObject> buffer_;
};

} // namespace ffgpu::gl
