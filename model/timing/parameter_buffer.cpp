#include "model/timing/parameter_buffer.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

constexpr std::uint64_t Base = std::uint64_t{1} << 48;     // above all textures and surfaces
constexpr std::uint64_t Distance = std::uint64_t{1} << 40; // of the buffers: more than any holds

} // namespace

ParameterBuffer::ParameterBuffer(const work::TileOrder& config, const PassToken& pass)
    : config_(&config)
    , plan_(&pass.scene->work.tiles)
    , pass_(&pass.plan())
    , base_(Base + pass.buffer * Distance) {}

ParameterBytes ParameterBuffer::record(std::uint32_t record) const {
    return {base_ + std::uint64_t{record - pass_->records_begin} * config_->record_bytes,
            config_->record_bytes};
}

ParameterBytes ParameterBuffer::header(std::uint32_t bin) const {
    const std::uint64_t records = pass_->records_end - pass_->records_begin;
    return {base_ + records * config_->record_bytes +
                std::uint64_t{bin - pass_->bins_begin} * config_->header_bytes,
            config_->header_bytes};
}

ParameterBytes
ParameterBuffer::entries(std::uint32_t bin, std::uint32_t begin, std::uint32_t end) const {
    const ParameterBytes first_header = header(pass_->bins_end);
    const std::uint64_t before =
        plan_->bins[bin].list_begin - plan_->bins[pass_->bins_begin].list_begin;
    return {first_header.address + (before + begin) * config_->entry_bytes,
            (end - begin) * config_->entry_bytes};
}

void add_requests(const ParameterBytes& bytes, bool write, std::deque<MemoryRequest>& requests) {
    const std::uint64_t end = bytes.address + bytes.bytes;
    for (std::uint64_t at = bytes.address; at < end;) {
        const std::uint64_t next =
            std::min(end, (at / ParameterBuffer::RequestBytes + 1) * ParameterBuffer::RequestBytes);
        requests.push_back({.address = at,
                            .bytes = static_cast<std::uint32_t>(next - at),
                            .write = write,
                            .client = Client::Parameter});
        at = next;
    }
}

} // namespace ffgpu::timing
