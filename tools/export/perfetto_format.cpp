// Chrome's trace events, which ui.perfetto.dev opens: a track for each unit with what it was busy
// or stalled on, one with the commands that the cycles are charged to, one with the frames, and
// counters of the bytes that each client moves and of the items in each queue. A cycle is drawn as
// a microsecond, the unit of the format, so that all times are whole numbers.

#include "tools/export/timeline_format.h"

namespace ffgpu::tools {
namespace {

using timing::Activity;

enum Process : unsigned { Units = 1, Commands = 2, Memory = 3, Queues = 4 };
constexpr unsigned CommandTrack = 1, FrameTrack = 2;

class Perfetto final : public TimelineFormat {
public:
    explicit Perfetto(TextWriter& out)
        : out_(out) {}

    void begin(const std::vector<std::string>& units) override {
        out_.print(FMT_COMPILE("{{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n"));
        name("process_name", Units, 0, "units (1 us is a cycle)");
        name("process_name", Commands, 0, "commands");
        name("process_name", Memory, 0, "memory");
        name("process_name", Queues, 0, "queues: items, in the mean");
        for (unsigned i = 0; i < units.size(); ++i)
            name("thread_name", Units, i + 1, units[i]);
        name("thread_name", Commands, CommandTrack, "commands");
        name("thread_name", Commands, FrameTrack, "frames");
        spans_.assign(units.size(), {});
    }

    void change(std::size_t unit, Activity activity, std::uint64_t time) override {
        Span& span = spans_[unit];
        close(unit, time);
        span = {activity, time};
    }

    void traffic(const TrafficInterval& interval) override {
        next();
        out_.print(FMT_COMPILE("{{\"name\":\"bytes\",\"ph\":\"C\",\"ts\":{},\"pid\":{},"
                               "\"tid\":0,\"args\":{{"),
                   interval.begin,
                   static_cast<unsigned>(Memory));
        for (std::size_t i = 0; i < interval.bytes.size(); ++i)
            out_.print(FMT_COMPILE("{}\"{}\":{}"),
                       i == 0 ? "" : ",",
                       timing::ClientNames[i],
                       interval.bytes[i]);
        out_.print(FMT_COMPILE("}}}}"));
    }

    void queues(const std::vector<std::string>& names) override {
        queues_.assign(names.begin(), names.end());
        items_.assign(names.size(), {});
    }

    // A counter keeps its value until the next.
    void queue_items(const QueueInterval& interval) override {
        for (std::size_t i = 0; i < queues_.size(); ++i) {
            std::string items = fmt::format(FMT_COMPILE("{:.3f}"), interval.items[i]);
            if (items == items_[i]) continue;
            next();
            out_.print(FMT_COMPILE("{{\"name\":\"{}\",\"ph\":\"C\",\"ts\":{},\"pid\":{},"
                                   "\"tid\":0,\"args\":{{\"items\":{}}}}}"),
                       queues_[i],
                       interval.begin,
                       static_cast<unsigned>(Queues),
                       items);
            items_[i] = std::move(items);
        }
    }

    void frame(const timing::FrameTiming& frame) override {
        slice(FrameTrack, fmt::format("frame {}", frame.frame), charged_, frame.cycles);
        for (const timing::CommandCycles& command : frame.commands) {
            const std::string_view kind =
                timing::CommandKindNames[static_cast<std::size_t>(command.kind)];
            slice(
                CommandTrack, fmt::format("{} {}", kind, command.number), charged_, command.cycles);
            charged_ += command.cycles;
        }
    }

    void end(std::uint64_t time) override {
        for (std::size_t unit = 0; unit < spans_.size(); ++unit)
            close(unit, time);
        out_.print(FMT_COMPILE("\n]}}\n"));
    }

private:
    struct Span {
        Activity activity = Activity::Idle;
        std::uint64_t begin = 0;
    };

    void next() {
        out_.print(FMT_COMPILE("{}"), first_ ? "" : ",\n");
        first_ = false;
    }

    void name(const char* what, unsigned process, unsigned track, const std::string& text) {
        next();
        out_.print(FMT_COMPILE("{{\"name\":\"{}\",\"ph\":\"M\",\"pid\":{},\"tid\":{},"
                               "\"args\":{{\"name\":\"{}\"}}}}"),
                   what,
                   process,
                   track,
                   text);
    }

    // Idle is what no span covers.
    void close(std::size_t unit, std::uint64_t time) {
        const Span& span = spans_[unit];
        if (span.activity == Activity::Idle || time == span.begin) return;
        next();
        out_.print(FMT_COMPILE("{{\"name\":\"{}\",\"ph\":\"X\",\"ts\":{},\"dur\":{},\"pid\":{},"
                               "\"tid\":{}}}"),
                   timing::ActivityNames[static_cast<std::size_t>(span.activity)],
                   span.begin,
                   time - span.begin,
                   static_cast<unsigned>(Units),
                   unit + 1);
    }

    void slice(unsigned track, const std::string& text, std::uint64_t begin, std::uint64_t cycles) {
        if (cycles == 0) return;
        next();
        out_.print(FMT_COMPILE("{{\"name\":\"{}\",\"ph\":\"X\",\"ts\":{},\"dur\":{},\"pid\":{},"
                               "\"tid\":{}}}"),
                   text,
                   begin,
                   cycles,
                   static_cast<unsigned>(Commands),
                   track);
    }

    TextWriter& out_;
    bool first_ = true;
    std::vector<Span> spans_;
    std::vector<std::string> queues_, items_; // names, and what was told last
    std::uint64_t charged_ = 0;               // cycles to commands so far
};

} // namespace

std::unique_ptr<TimelineFormat> make_perfetto(TextWriter& out) {
    return std::make_unique<Perfetto>(out);
}

} // namespace ffgpu::tools
