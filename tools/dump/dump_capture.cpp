#include "tools/dump/dump_capture.h"

#include "model/capture/capture_reader.h"
#include "tools/dump/contract_names.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Out = std::function<void(std::string_view)>;

// A device that prints what it is told.
class DumpDevice final : public Device {
public:
    DumpDevice(const DumpOptions& options, std::uint64_t memory_bytes, const Out& out)
        : words_(options.words)
        , memory_bytes_(memory_bytes)
        , out_(out) {}

    std::uint64_t memory_size() const override { return memory_bytes_; }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        note(fmt::format("write_memory: address {:#010x}, bytes {}", at, bytes.size()));
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        note(fmt::format("read_memory: address {:#010x}, bytes {}", at, bytes.size()));
    }
    void submit(const CommandStream& commands) override {
        for_each_command(commands.words, [this](const CommandReader& reader) {
            if (words_)
                print_words(reader);
            else
                out_(names_.command(reader) + '\n');
        });
    }
    void finish() override { note("finish"); }
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

    // A comment among words, a line else.
    void note(const std::string& line) { out_((words_ ? "// " : "") + line + '\n'); }

private:
    void print_words(const CommandReader& reader) {
        out_("// " + names_.name(reader) + '\n');
        for (const std::uint32_t word : reader.whole())
            out_(fmt::format("{:08x}\n", word));
    }

    const bool words_;
    const std::uint64_t memory_bytes_;
    const Out& out_;
    ContractNames names_;
};

} // namespace

void dump_capture(const DumpOptions& options, const Out& out) {
    capture::CaptureReader reader(options.input);
    DumpDevice device(options, reader.memory_size(), out);
    device.note(
        fmt::format("memory {} bytes, first frame {}", reader.memory_size(), reader.first_frame()));
    reader.play_snapshot(device);
    device.note(fmt::format("snapshot_end: next draw {}", reader.first_draw()));
    while (const auto shown = reader.play_frame(device)) {
        const Surface& picture = shown->picture;
        device.note(fmt::format("shown: frame {}, address {:#010x}, {}x{} {}",
                                shown->frame,
                                picture.address,
                                picture.width,
                                picture.height,
                                format_info(picture.format).name));
    }
}

} // namespace ffgpu::tools
