#include "tests/gallery/offscreen/draw.h"

#include "driver/window_system/offscreen/osmesa.h"
#include "model/base/check.h"

#include <cstdlib>
#include <string>

namespace ffgpu::gallery {

Picture draw_offscreen(const Program& program, bool broken) {
    // What `ffgpu run --set gpu.supersampling=N` tells the library.
    ::setenv("FFGPU_SUPERSAMPLING", std::to_string(program.supersampling).c_str(), 1);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    check(context, "an off-screen context");
    constexpr std::size_t Pixels = std::size_t{WindowWidth} * WindowHeight;
    std::vector<std::uint8_t> rgba(4 * Pixels);
    check(OSMesaMakeCurrent(context, rgba.data(), GL_UNSIGNED_BYTE, WindowWidth, WindowHeight),
          "the context becomes current");
    program.draw({WindowWidth, WindowHeight, broken});
    glFinish();
    check(glGetError() == GL_NO_ERROR, "a program of the gallery makes no GL error");
    OSMesaDestroyContext(context);

    Picture picture;
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 != 3) picture.push_back(rgba[i]);
    }
    return picture;
}

} // namespace ffgpu::gallery
