#include "model/timing/tile_path.h"

namespace ffgpu::timing {

TilePath::TilePath(const Clock& clock, const TimingConfig& config, const Ports& ports)
    : ports_(ports)
    , binner_requests_(clock, config.tiles.request_queue, ports.memory_in_flight)
    , fetch_requests_(clock, config.tiles.request_queue, ports.memory_in_flight)
    , memory_requests_(clock, config.tiles.request_queue, ports.memory_in_flight)
    , fetch_responses_(clock, ResponseQueue)
    , memory_responses_(clock, ResponseQueue)
    , passes_(clock, config.tiles.parameter_buffers)
    , fetched_bins_(clock, 1)
    , free_buffers_(clock, config.tiles.parameter_buffers)
    , binner_("binner",
              clock,
              config.tiles,
              {.setups_in = ports.setups_in,
               .passes_out = passes_,
               .free_buffers_in = free_buffers_,
               .requests_out = binner_requests_},
              ports.in_flight)
    , fetch_("parameter_fetch",
             clock,
             config.tiles,
             {.passes_in = passes_,
              .bins_out = fetched_bins_,
              .requests_out = fetch_requests_,
              .responses_in = fetch_responses_})
    , memory_("tile_memory",
              clock,
              config.tiles,
              config.raster.bin_size,
              {.bins_in = fetched_bins_,
               .bins_out = ports.bins_out,
               .free_buffers_out = free_buffers_,
               .requests_out = memory_requests_,
               .responses_in = memory_responses_},
              ports.in_flight) {}

void TilePath::connect(Unit& setup, Unit& raster, Unit& arbiter) {
    ports_.setups_in.connect("setups", setup, binner_);
    passes_.connect("passes", binner_, fetch_);
    fetched_bins_.connect("fetched_bins", fetch_, memory_);
    free_buffers_.connect("free_buffers", memory_, binner_);
    ports_.bins_out.connect("bins", memory_, raster);
    binner_requests_.channel().connect("binner_requests", binner_, arbiter);
    fetch_requests_.channel().connect("parameter_fetch_requests", fetch_, arbiter);
    memory_requests_.channel().connect("tile_memory_requests", memory_, arbiter);
    fetch_responses_.connect("parameter_fetch_responses", arbiter, fetch_);
    memory_responses_.connect("tile_memory_responses", arbiter, memory_);
}

void TilePath::add_to(MemoryArbiter::Ports& arbiter) {
    for (RequestPort* const port : {&binner_requests_, &fetch_requests_, &memory_requests_})
        arbiter.requests_in.push_back(&port->channel());
    arbiter.responses_out.insert(arbiter.responses_out.end(),
                                 {nullptr, &fetch_responses_, &memory_responses_});
}

} // namespace ffgpu::timing
