// The price of the work stream itself: a trace or a capture is drawn on one thread, and its work
// handed to nobody (`record`) or not recorded (`draw`). bench.py compares the processor time of the
// two: what files, machines and studies of caches make of the stream is none of it.

#include "model/gpu/functional_gpu.h"
#include "tools/frames/frame_source.h"

#include <cstdio>
#include <exception>
#include <string_view>

namespace {

class NobodyReads final : public ffgpu::WorkSink {
    void bin(std::shared_ptr<const ffgpu::WorkBin>) override {}
    void end_frame(std::uint32_t) override {}
};

void play(const char* path, bool records) {
    NobodyReads nobody;
    ffgpu::FunctionalGpu gpu({});
    if (records) gpu.set_work_sink(&nobody);
    const auto source =
        ffgpu::tools::open_frame_source(path, gpu, {.warn = [](const std::string&) {}});
    source->prepare();
    while (source->next())
        ;
    gpu.finish();
}

} // namespace

int main(int argc, char** argv) {
    const std::string_view mode = argc == 3 ? argv[1] : "";
    if (mode != "draw" && mode != "record") {
        std::fprintf(stderr, "usage: work_stream draw|record FILE\n");
        return 2;
    }
    try {
        play(argv[2], mode == "record");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "work_stream: %s\n", error.what());
        return 2;
    }
    return 0;
}
