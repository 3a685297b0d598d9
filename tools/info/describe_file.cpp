#include "tools/info/describe_file.h"

#include "model/base/input_error.h"
#include "model/capture/capture_reader.h"
#include "model/work/work_file_reader.h"
#include "tools/frames/frame_source.h"
#include "tools/info/census_device.h"
#include "tools/info/trace_calls.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// Which frames there are, and how large their pictures.
class Frames {
public:
    void add(std::uint64_t number, std::uint32_t width, std::uint32_t height) {
        if (count_++ == 0) first_ = number;
        last_ = number;
        ++sizes_[fmt::format("{}x{}", width, height)];
    }

    std::string text() const {
        if (count_ == 0) return "frames: none\n";
        std::string text = fmt::format("frames: {}, {} to {}\n", count_, first_, last_);
        for (const auto& [size, frames] : sizes_)
            text += fmt::format("  {:6} of {} pixels\n", frames, size);
        return text;
    }

private:
    std::uint64_t count_ = 0, first_ = 0, last_ = 0;
    std::map<std::string, std::uint64_t> sizes_;
};

// Of a trace or capture: played on a device that draws nothing. `notes` are what the player warns
// of.
std::string describe_frames(const std::string& path, std::set<std::string>& notes) {
    CensusDevice device;
    const auto warn = [&](const std::string& line) { notes.insert(line); };
    const auto source = open_frame_source(path, device, {.warn = warn});
    device.set_counting(false);
    source->prepare();
    device.set_counting(true);
    Frames frames;
    while (const auto frame = source->next())
        frames.add(frame->number, frame->picture.width, frame->picture.height);
    return frames.text() + device.census().text();
}

// Of whole commands.
class CensusOfWork final : public work::CommandSink {
public:
    Census census;

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        const WorkDraw& draw = command->draw;
        if (draw.kind == WorkKind::Draw) census.draw(*draw.state, draw.geometry.vertices.size());
        if (draw.kind == WorkKind::Image) census.image(*draw.state);
        if (draw.kind == WorkKind::Clear) census.clear();
        if (draw.kind == WorkKind::Copy) census.copy();
    }
    void host_transfer(const HostTransfer& transfer) override {
        if (transfer.is_write) census.upload(transfer.bytes);
    }
    void end_frame(std::uint32_t) override {}
};

std::string describe_work(const std::string& path) {
    work::WorkFileReader reader(path);
    CensusOfWork sink;
    Frames frames;
    reader.play(sink, [&](const work::FrameFigures& frame) {
        frames.add(frame.number, frame.width, frame.height);
    });
    return path + ": a work file\n" + frames.text() + sink.census.text();
}

std::string describe_capture(const std::string& path) {
    const capture::CaptureReader reader(path);
    std::set<std::string> notes;
    return fmt::format("{}: a device capture, of a device with {} bytes of memory\n",
                       path,
                       reader.memory_size()) +
           describe_frames(path, notes);
}

std::string describe_trace(const std::string& path) {
    const std::string calls = describe_calls(path);
    std::set<std::string> notes;
    std::string text = path + ": " + calls.substr(0, calls.find('\n') + 1) +
                       describe_frames(path, notes) + calls.substr(calls.find('\n') + 1);
    for (const std::string& note : notes)
        text += "note: " + note + '\n';
    return text;
}

} // namespace

std::string describe_file(const std::string& path) {
    if (work::WorkFileReader::is_work_file(path)) return describe_work(path);
    if (capture::CaptureReader::is_capture(path)) return describe_capture(path);
    return describe_trace(path);
}

} // namespace ffgpu::tools
