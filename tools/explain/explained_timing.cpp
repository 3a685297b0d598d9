#include "tools/explain/explained_timing.h"

namespace ffgpu::tools {
namespace {

timing::QuadName quad_of(const FragmentNote& note) {
    return {.draw = note.key.draw,
            .primitive = note.key.primitive,
            .piece = note.piece,
            .x = static_cast<std::uint16_t>(note.x & ~1u),
            .y = static_cast<std::uint16_t>(note.y & ~1u)};
}

bool is_border(const probed::Texel& texel) {
    return texel.bytes == 0;
}

} // namespace

ExplainedTiming::ExplainedTiming(const timing::TimingConfig& config,
                                 const HistoryCollector& collector)
    : config_(config)
    , collector_(collector)
    , order_(config_.work(), no_machine_)
    , assembler_(*this)
    , timing_(config) {
    timing_.set_quad_observer(this);
}

// The addresses are those of this moment: a texture that is written again moves.
void ExplainedTiming::command(std::shared_ptr<const work::WholeCommand> command) {
    order_.command(command);
    const bool has_fragments =
        command->draw.kind == WorkKind::Draw || command->draw.kind == WorkKind::Image;
    if (has_fragments) {
        const std::lock_guard lock(mutex_);
        for (const auto& note : collector_.fragments_of(command->draw.number)) {
            note_lines(*note);
            quads_[quad_of(*note)].push_back(note);
        }
    }
    timing_.command(std::move(command));
}

void ExplainedTiming::note_lines(FragmentNote& note) {
    for (const TextureNote& texture : note.textures) {
        if (texture.probes.empty()) continue;
        const auto& levels = order_.addresses().texture(note.registers().images[texture.unit]);
        for (const ProbeNote& probe : texture.probes)
            for (const probed::LevelFilter& filter : probe.levels)
                for (unsigned i = 0; i < filter.texel_count; ++i) {
                    const probed::Texel& texel = filter.texels[i];
                    if (is_border(texel)) continue;
                    const std::uint32_t line_bytes = config_.texel_cache.line_bytes;
                    note.timing.lookups.push_back({.unit = texture.unit,
                                                   .level = filter.access.level,
                                                   .x = texel.x,
                                                   .y = texel.y,
                                                   .layer = texel.layer,
                                                   .line = levels[filter.access.level].line(
                                                       texel.x, texel.y, texel.layer, line_bytes)});
                }
    }
}

void ExplainedTiming::content(const std::shared_ptr<const SurfaceContent>& content) {
    if (!config_.needs_values().empty()) order_.content(content);
    timing_.content(content);
}

void ExplainedTiming::host_transfer(const HostTransfer& transfer) {
    order_.host_transfer(transfer);
    timing_.host_transfer(transfer);
}

void ExplainedTiming::end_frame(std::uint32_t frame) {
    order_.end_frame(frame);
    timing_.end_frame(frame);
}

// The first look-up of a line is the one that may miss.
void ExplainedTiming::texel_line(const timing::QuadName& quad, const timing::CacheLine& line) {
    const std::lock_guard lock(mutex_);
    const auto found = quads_.find(quad);
    if (found == quads_.end()) return;
    for (const auto& note : found->second)
        for (TexelLookup& lookup : note->timing.lookups) {
            if (lookup.line != line.number || lookup.cycle) continue;
            lookup.missed = line.missed;
            lookup.cycle = line.cycle;
        }
}

void ExplainedTiming::depth_line(const timing::QuadName& quad, const timing::CacheLine& line) {
    note_target(quad, {TargetLookup::Cache::Depth, line.number, line.missed, line.cycle});
}

void ExplainedTiming::color_line(const timing::QuadName& quad, const timing::CacheLine& line) {
    note_target(quad, {TargetLookup::Cache::Color, line.number, line.missed, line.cycle});
}

void ExplainedTiming::note_target(const timing::QuadName& quad, const TargetLookup& lookup) {
    const std::lock_guard lock(mutex_);
    const auto found = quads_.find(quad);
    if (found == quads_.end()) return;
    for (const auto& note : found->second)
        note->timing.targets.push_back(lookup);
}

void ExplainedTiming::retired(const timing::QuadName& quad, std::uint64_t cycle) {
    const std::lock_guard lock(mutex_);
    const auto found = quads_.find(quad);
    if (found == quads_.end()) return;
    for (const auto& note : found->second)
        note->timing.retired = cycle;
}

} // namespace ffgpu::tools
