// What ffgpu_pictures.so exports: a reader of all the formats that OpenImageIO knows. The library
// brings some 260 others, so that only who needs it loads it.

#pragma once

#include "tools/image/image.h"

namespace ffgpu::tools {

// False: `why` says so. Exceptions do not leave it.
using ReadPicture = bool (*)(const std::string& path, Image& image, std::string& why);
constexpr const char* ReadPictureName = "ffgpu_read_picture";

} // namespace ffgpu::tools
