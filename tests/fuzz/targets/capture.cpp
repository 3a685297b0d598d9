// A device capture, played on the functional GPU.

#include "model/base/input_error.h"
#include "model/capture/capture_reader.h"
#include "tests/fuzz/kept_gpu.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/packing.h"

void ffgpu::fuzz::run(Bytes bytes) {
    const MemoryFile file(pack_capture(bytes));
    const KeptGpu<64> kept;
    FunctionalGpu& gpu = KeptGpu<64>::gpu();
    try {
        capture::CaptureReader reader(file.path());
        if (reader.memory_size() > gpu.memory_size()) return;
        reader.play_snapshot(gpu);
        while (reader.play_frame(gpu)) {
        }
        reader.expect_frames();
    } catch (const InputError&) {
    } catch (const std::bad_alloc&) { // The device's memory is small.
    }
}
