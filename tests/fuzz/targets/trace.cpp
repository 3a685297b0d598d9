// A trace of an OpenGL program, played on the functional GPU.

#include "model/base/input_error.h"
#include "tests/fuzz/kept_gpu.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/packing.h"
#include "tools/frames/frame_source.h"

void ffgpu::fuzz::run(Bytes bytes) {
    const MemoryFile file(pack_trace(bytes));
    const KeptGpu<64> kept;
    FunctionalGpu& gpu = KeptGpu<64>::gpu();
    try {
        const auto source =
            tools::open_frame_source(file.path(), gpu, {.warn = [](const std::string&) {}});
        source->prepare();
        while (source->next()) {
        }
    } catch (const InputError&) {
    } catch (const std::bad_alloc&) { // The device's memory is small.
    }
}
