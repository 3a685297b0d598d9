#include "tools/info/trace_calls.h"

#include "driver/trace/reader/trace_reader.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

// Where a command comes from that is in none of OpenGL 1.0 to 1.5; empty for the others.
std::string_view origin_of(std::string_view name) {
    static const std::map<std::string_view, std::string_view> origins{
#define GL_ORIGIN(command, origin) {"gl" #command, origin},
#include "driver/commands/command_origins.inc"
#undef GL_ORIGIN
    };
    const auto found = origins.find(name);
    return found == origins.end() ? std::string_view() : found->second;
}

class CallCounts {
public:
    void add(const trace::Call& call) {
        ++calls_;
        threads_.insert(call.thread());
        ++by_name_[std::string(call.name())];
        if (makes_context(call)) ++contexts_;
    }

    std::string text(std::uint64_t version) const {
        std::string text = fmt::format("a trace (version {}): {} calls in {} {}, {} {} made\n",
                                       version,
                                       calls_,
                                       threads_.size(),
                                       threads_.size() == 1 ? "thread" : "threads",
                                       contexts_,
                                       contexts_ == 1 ? "context" : "contexts");
        text += describe_origins();
        std::vector<std::pair<std::string, std::uint64_t>> sorted(by_name_.begin(), by_name_.end());
        std::ranges::stable_sort(
            sorted, std::ranges::greater(), [](const auto& entry) { return entry.second; });
        text += fmt::format("calls of {} functions:\n", sorted.size());
        for (const auto& [name, count] : sorted)
            text += fmt::format("  {:6} {}\n", count, name);
        return text;
    }

private:
    static bool makes_context(const trace::Call& call) {
        const std::string_view name = call.name();
        const bool creates = name.find("CreateContext") != std::string_view::npos ||
                             name == "glXCreateNewContext" || name == "wglCreateLayerContext";
        return creates && !call.result().is_null() && call.result().bits != 0;
    }

    std::string describe_origins() const {
        std::map<std::string_view, std::uint64_t> origins;
        for (const auto& [name, count] : by_name_)
            if (const std::string_view origin = origin_of(name); !origin.empty())
                origins[origin] += count;
        if (origins.empty()) return "extensions: none with functions of their own\n";
        std::string text = "extensions and later versions, with the calls of their functions:\n";
        for (const auto& [origin, count] : origins)
            text += fmt::format("  {:6} {}\n", count, origin);
        return text;
    }

    std::uint64_t calls_ = 0, contexts_ = 0;
    std::set<std::uint32_t> threads_;
    std::map<std::string, std::uint64_t> by_name_;
};

} // namespace

std::string describe_calls(const std::string& path) {
    trace::TraceReader reader(path);
    CallCounts counts;
    while (const trace::Call* const call = reader.next())
        counts.add(*call);
    return counts.text(reader.version());
}

} // namespace ffgpu::tools
