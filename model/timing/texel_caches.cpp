#include "model/timing/texel_caches.h"

namespace ffgpu::timing {

TexelCaches::TexelCaches(const Clock& clock, const TimingConfig& config, InFlight& in_flight) {
    const bool per_pipe = config.texel_cache.per_pipe && config.raster.quads_per_cycle > 1;
    const std::string name(TexelCacheConfig::Name);
    const TexelL2Config& l2 = config.texel_l2;
    for (std::uint32_t pipe = 0; pipe < (per_pipe ? config.raster.quads_per_cycle : 1); ++pipe) {
        names_.push_back(per_pipe ? name + '_' + std::to_string(pipe) : name);
        first_level_.emplace_back(names_.back(),
                                  clock,
                                  config.texel_cache.cache(),
                                  Client::Texture,
                                  in_flight,
                                  l2.enable ? l2.latency : 1);
    }
    if (per_pipe) sum_ = std::make_unique<CacheStatistics>(name);
    if (!l2.enable) return;
    l2_port_ = std::make_unique<CachePort>(
        TexelL2Config::Name, clock, l2.cache(), Client::Texture, in_flight);
    l2_ =
        std::make_unique<TexelL2>("texel_l2",
                                  clock,
                                  l2,
                                  TexelL2::Ports{.first_level = first_level(), .memory = *l2_port_},
                                  in_flight);
}

std::vector<CachePort*> TexelCaches::first_level() {
    std::vector<CachePort*> ports;
    for (CachePort& port : first_level_)
        ports.push_back(&port);
    return ports;
}

std::vector<CachePort*> TexelCaches::at_memory() {
    return l2_ ? std::vector<CachePort*>{l2_port_.get()} : first_level();
}

void TexelCaches::connect(Unit& texture, Unit& arbiter) {
    for (CachePort& port : first_level_)
        port.connect(texture, l2_ ? *l2_ : arbiter);
    if (l2_) l2_port_->connect(*l2_, arbiter);
}

void TexelCaches::settle() {
    if (!sum_) return;
    std::vector<const StatisticsGroup*> parts;
    for (const CachePort& port : first_level_)
        parts.push_back(&port.cache.statistics());
    sum_->set_to_sum_of(parts);
}

std::vector<const StatisticsGroup*> TexelCaches::statistics() const {
    std::vector<const StatisticsGroup*> groups;
    if (sum_) groups.push_back(sum_.get());
    for (const CachePort& port : first_level_)
        groups.push_back(&port.cache.statistics());
    if (l2_) groups.push_back(&l2_port_->cache.statistics());
    return groups;
}

} // namespace ffgpu::timing
