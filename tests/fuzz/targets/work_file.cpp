// A work file, read to its end: every command's sizes, indices and masks are looked at.

#include "model/base/input_error.h"
#include "model/work/prepared_work.h"
#include "model/work/work_file_reader.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/packing.h"

namespace {

class Counter final : public ffgpu::work::CommandSink {
public:
    void command(std::shared_ptr<const ffgpu::work::WholeCommand> command) override {
        quads += command->quads.size();
    }
    void host_transfer(const ffgpu::HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

    std::size_t quads = 0;
};

} // namespace

void ffgpu::fuzz::run(Bytes bytes) {
    const MemoryFile file(pack_work_file(bytes));
    try {
        Counter counter;
        work::WorkFileReader(file.path()).play(counter, [](const work::FrameFigures&) {});
    } catch (const InputError&) {
    }
}
