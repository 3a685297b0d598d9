// Value change dump (IEEE 1364): of each unit a vector of three bits, its activity.

#include "tools/export/timeline_format.h"

namespace ffgpu::tools {
namespace {

class Vcd final : public TimelineFormat {
public:
    explicit Vcd(TextWriter& out)
        : out_(out) {}

    void begin(const std::vector<std::string>& units) override {
        out_.print(FMT_COMPILE("$comment a unit of time is a cycle; activity:"));
        for (std::size_t i = 0; i < timing::ActivityNames.size(); ++i)
            out_.print(FMT_COMPILE(" {} {}"), i, timing::ActivityNames[i]);
        out_.print(FMT_COMPILE(" $end\n$timescale 1 ns $end\n$scope module ffgpu $end\n"));
        for (std::size_t i = 0; i < units.size(); ++i)
            out_.print(FMT_COMPILE("$scope module {} $end\n$var wire 3 {} activity $end\n"
                                   "$upscope $end\n"),
                       units[i],
                       code(i));
        out_.print(FMT_COMPILE("$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n"));
        for (std::size_t i = 0; i < units.size(); ++i)
            value(i, timing::Activity::Idle);
        out_.print(FMT_COMPILE("$end\n"));
    }

    void change(std::size_t unit, timing::Activity activity, std::uint64_t time) override {
        go_to(time);
        value(unit, activity);
    }

    void end(std::uint64_t time) override { go_to(time); }

private:
    // Printable characters from '!' on: there are fewer units than those.
    static char code(std::size_t unit) { return static_cast<char>('!' + unit); }

    void value(std::size_t unit, timing::Activity activity) {
        out_.print(FMT_COMPILE("b{:b} {}\n"), static_cast<unsigned>(activity), code(unit));
    }
    void go_to(std::uint64_t time) {
        if (time == time_) return;
        time_ = time;
        out_.print(FMT_COMPILE("#{}\n"), time);
    }

    TextWriter& out_;
    std::uint64_t time_ = 0;
};

} // namespace

std::unique_ptr<TimelineFormat> make_vcd(TextWriter& out) {
    return std::make_unique<Vcd>(out);
}

} // namespace ffgpu::tools
