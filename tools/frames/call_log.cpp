#include "tools/frames/call_log.h"

#include "driver/context/waiting_vertices.h"

#include <algorithm>

namespace ffgpu::tools {
const CallName* VertexCalls::call_of(std::uint32_t vertex) const {
    const auto found = std::ranges::upper_bound(entries, vertex, {}, &Entry::vertices);
    return found == entries.end() ? nullptr : &found->call;
}

void CallLog::begin(std::uint64_t number, std::string_view name) {
    const std::uint32_t vertices = gl::waiting_vertices();
    std::vector<VertexCalls::Entry>& entries = waiting_.entries;
    const std::uint32_t before = entries.empty() ? 0 : entries.back().vertices;
    if (vertices < before) entries.clear(); // They were drawn.
    if (vertices > 0 && vertices != before) entries.push_back({call_, vertices});
    call_ = {number, std::string(name)};
}

std::shared_ptr<const VertexCalls> CallLog::waiting() const {
    if (!gl::vertices_wait() || waiting_.entries.empty()) return nullptr;
    return std::make_shared<const VertexCalls>(waiting_);
}

} // namespace ffgpu::tools
