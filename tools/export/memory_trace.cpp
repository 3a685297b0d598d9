#include "tools/export/memory_trace.h"

#include "model/work/texel_line.h"

#include <algorithm>
#include <utility>

namespace ffgpu::tools {

void TexturePlaces::add(const work::WholeCommand& command, work::MachineOrder& order) {
    if (!command.draw.state) return;
    const std::lock_guard lock(mutex_);
    for (const std::uint8_t unit : command.units) {
        const TextureImage& image = command.draw.state->images[unit];
        if (image.shape.kind == TextureKind::None) continue;
        std::uint32_t number = 0;
        for (const work::PlacedLevel& level : order.addresses().texture(image)) {
            const std::uint64_t layers = level_layout(image.shape, number).layers;
            levels_.try_emplace(
                level.base,
                Level{{image.address, number}, level.base + level.layer_bytes * layers});
            ++number;
        }
    }
}

std::optional<TexelPlace> TexturePlaces::find(std::uint64_t address) const {
    const std::lock_guard lock(mutex_);
    const auto after = levels_.upper_bound(address);
    if (after == levels_.begin()) return std::nullopt;
    const Level& level = std::prev(after)->second;
    return address < level.end ? std::optional(level.place) : std::nullopt;
}

MemoryTrace::MemoryTrace(std::unique_ptr<MemoryFormat> format,
                         std::uint32_t line_bytes,
                         const TexturePlaces& places,
                         TextWriter& out)
    : format_(std::move(format))
    , line_bytes_(line_bytes)
    , places_(places)
    , out_(out)
    , writer_(8 * Chunk) {
    writer_.push(1, [this] { format_->begin(out_); });
}

void MemoryTrace::texel_line(const timing::QuadName& quad, const timing::CacheLine& line) {
    if (line.missed) askers_.emplace(work::line_source(line.number, line_bytes_).address, quad);
}

// A line may be missed again before its first miss is sent.
std::optional<timing::QuadName> MemoryTrace::asker(const timing::MemoryRequest& request) {
    if (request.client != timing::Client::Texture) return std::nullopt;
    const auto found = askers_.lower_bound(request.address);
    if (found == askers_.end() || found->first != request.address) return std::nullopt;
    const timing::QuadName quad = found->second;
    askers_.erase(found);
    return quad;
}

void MemoryTrace::sent(const timing::MemoryRequest& request, std::uint64_t cycle) {
    const bool of_screen = request.client == timing::Client::ScanOut;
    if (of_screen || !waiting_.empty())
        waiting_.push_back({request, cycle, !of_screen, asker(request)});
    else
        hand_over({request, cycle, true, asker(request)});
}

void MemoryTrace::done(const timing::MemoryRequest& request, std::uint64_t) {
    if (request.client != timing::Client::ScanOut) return;
    const auto found =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const TracedRequest& traced) {
            return !traced.counts && traced.request.address == request.address &&
                   traced.request.issued == request.issued;
        });
    if (found != waiting_.end()) found->counts = true;
    hand_over_known();
}

void MemoryTrace::count(const timing::MemoryRequest& request) {
    ClientTraffic& traffic = traffic_[static_cast<std::size_t>(request.client)];
    ++traffic.requests;
    (request.write ? traffic.written_bytes : traffic.read_bytes) += request.bytes;
}

void MemoryTrace::hand_over(const TracedRequest& traced) {
    count(traced.request);
    chunk_.push_back(traced);
    if (chunk_.size() >= Chunk) write_chunk();
}

void MemoryTrace::hand_over_known() {
    for (; !waiting_.empty() && waiting_.front().counts; waiting_.pop_front())
        hand_over(waiting_.front());
}

void MemoryTrace::write_chunk() {
    std::vector<TracedRequest> chunk;
    chunk.reserve(Chunk);
    chunk.swap(chunk_);
    const std::size_t weight = 1 + chunk.size(); // An argument may move what another one asks.
    writer_.push(weight, [this, chunk = std::move(chunk)] {
        for (const TracedRequest& traced : chunk) {
            const bool of_texture = traced.request.client == timing::Client::Texture;
            format_->write(
                traced, of_texture ? places_.find(traced.request.address) : std::nullopt, out_);
        }
    });
}

void MemoryTrace::finish() {
    std::erase_if(waiting_, [](const TracedRequest& traced) { return !traced.counts; });
    hand_over_known();
    write_chunk();
    writer_.push(1, [this] { out_.flush(); });
    writer_.drain();
}

} // namespace ffgpu::tools
