// FunctionalGpu: the device that draws. It is the block diagram:
//
//     commands -> registers -> geometry -> set-up -> bin
//     bin, tile by tile on the other threads while the next is filled, or on all:
//         coverage -> early depth -> interpolation -> texture units -> environments .. write
//
// Geometry runs while commands are submitted, that of long draws on all threads; pixels wait in a
// bin until somebody may look at them. Each tile works in the order of the commands, and no stage
// looks across tiles: the result depends neither on the number of threads nor on the tile size.

#pragma once

#include "model/device/command_reader.h"
#include "model/device/device.h"
#include "model/device/register_file.h"
#include "model/gpu/bin_sequence.h"
#include "model/gpu/bin_stock.h"
#include "model/gpu/cleared_tiles.h"
#include "model/gpu/geometry_worker.h"
#include "model/gpu/raster_statistics.h"
#include "model/gpu/stages.h"
#include "model/gpu/surface_journal.h"
#include "model/gpu/thread_pool.h"
#include "model/gpu/tile_renderer.h"
#include "model/memory/device_memory.h"
#include "model/packets/stage_probe.h"
#include "model/packets/work_stream.h"

#include <functional>
#include <memory>
#include <vector>

namespace ffgpu {

class FunctionalGpu final : public Device, private BinSupply {
public:
    struct Config {
        unsigned threads = 1;   // for tiles and long draws, the caller's included
        unsigned tile_size = 0; // pixels: a multiple of 8 from 16 to 128; 0: by the targets
        std::uint64_t memory_bytes = DeviceMemory::DefaultBytes;
        std::size_t bin_bytes = std::size_t{512} << 10; // of records: they stay in a level-2 cache
        const Stages* stages = &FastStages;             // or &ReferenceStages: the same frames
        // Whether the other threads may take part in what begins now; null: always.
        std::function<bool()> may_share = nullptr;
        // false: for who wants the work alone, without values. Colours are drawn where they decide
        // on fragments: see missed_colors().
        bool colors = true;
    };

    explicit FunctionalGpu(const Config& config);
    ~FunctionalGpu() override;

    // As it was made, with the sink and the probe that it has: memory and counters are zero,
    // registers at their reset values.
    void reset();

    // From now on work is recorded and handed to `sink`; null: no more.
    void set_work_sink(WorkSink* sink, WorkDetail detail = WorkDetail::Masks);
    // What is read from now on, until nothing is hidden, is no work of the machine's. Nothing may
    // be drawn or written in between.
    void hide_from_work(bool hidden);

    // From now on `probe` is told what each stage does (model/packets/stage_probe.h), and tiles are
    // carried out on the caller's thread alone; null: no more.
    void set_stage_probe(StageProbe* probe);

    // The frame under way and the next draw get these numbers: for a device that goes on where
    // another was captured.
    void number_from(std::uint32_t frame, std::uint32_t draw);

    // Whether what was recorded, or read, may depend on colours that were not drawn: it has to be
    // drawn again, with all of them.
    bool missed_colors() const { return missed_colors_; }

    const Registers& registers() const { return registers_.values(); }

    // All of device memory with everything drawn that was submitted: for who draws on it in this
    // GPU's place, before the next command.
    std::span<std::byte> settled_memory();

    std::uint64_t memory_size() const override { return memory_.size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    // Throws InputError for a stream that is damaged; what came before the fault is done.
    void submit(const CommandStream& commands) override;
    void finish() override;
    std::vector<const StatisticsGroup*> statistics() const override;
    // How the host worked: tiles, batches, bins. No property of the device.
    const StatisticsGroup& host_statistics() const { return host_statistics_; }

private:
    GeometryUnit& geometry() { return geometry_[0]->geometry; }
    PrimitiveStatistics& primitive_statistics() { return geometry_[0]->binner.statistics(); }
    Bin& bin() { return *bins_.bins.back(); }

    // Commands.
    void execute(const CommandReader& reader);
    void write_register(const CommandReader::RegisterWrite& write);
    void draw(const DrawCommand& command);
    void clear(const ClearCommand& command);
    void draw_image(const DrawImageCommand& command);
    void copy(const CopyRectangleCommand& command);
    void reset_samples();
    void store_samples(const StoreSampleCounterCommand& command);
    void end_frame();

    // Draws.
    void prepare_context();
    void begin_command(BinCommand command);
    Bin& next_bin() override;
    void draw_in_geometry(const DrawCommand& command);
    void draw_in_chunks(const DrawCommand& command, std::uint32_t number, std::uint32_t chunks);
    class ChunkBins;
    GeometryWorker& geometry_of(unsigned worker);
    bool reads_own_target(const DrawContext& context, const DrawCommand& command) const;

    // Bins.
    void before_read(std::uint64_t at, std::uint64_t bytes);      // by whom its values matter to
    void before_bin_reads(std::uint64_t at, std::uint64_t bytes); // for colours that nobody wants
    void before_write(std::uint64_t at, std::uint64_t bytes);
    void forget_contents(std::uint64_t at, std::uint64_t bytes);
    void leave_undrawn(const Targets& targets);
    void flush();     // All that was submitted is in memory.
    void carry_out(); // The bins at hand are drawn, perhaps while the next ones are filled.
    void finish_carrying();
    void put_under_way();
    void end_under_way();
    void draw_and_record(bool alone);
    void open_bin(const Targets& targets);
    std::unique_ptr<Bin> make_bin();
    void tell_contents(const Targets& targets);
    bool records_values() const { return sink_ && detail_ == WorkDetail::Values; }
    void hand_over(std::vector<WorkTile> tiles, std::vector<std::shared_ptr<ChunkMemory>> memory);
    void note_transfer(bool is_write, std::uint64_t at, std::uint64_t bytes);

    const Config config_;
    DeviceMemory memory_;
    RegisterFile registers_;
    ThreadPool pool_;
    std::vector<std::unique_ptr<GeometryWorker>> geometry_; // one a thread, as it is needed
    std::vector<std::unique_ptr<TileRenderer>> renderers_;  // one a thread
    std::shared_ptr<ChunkPool> record_chunks_ = std::make_shared<ChunkPool>();
    WorkSink* sink_ = nullptr;
    WorkDetail detail_ = WorkDetail::Masks;
    bool hidden_ = false;
    StageProbe* probe_ = nullptr;

    BinStock stock_;
    BinSequence bins_;      // Where commands go: to the last.
    BinSequence under_way_; // Other threads draw them while the next are filled,
    std::vector<std::uint32_t> under_way_tiles_; // tile by tile.
    RangeSet undrawn_;                           // where colours are not those that were drawn
    bool missed_colors_ = false;
    Targets bin_targets_; // what the bins draw into
    ClearedTargets cleared_;
    bool bin_serial_ = false; // A draw reads what it writes: one thread, so that it repeats.
    PixelContexts pixel_contexts_;
    std::shared_ptr<const DrawContext> context_; // of the registers, where it is valid
    bool context_valid_ = false;
    bool pixels_valid_ = false; // context_->pixels is, though geometry's registers changed
    std::shared_ptr<const PixelContext> binned_pixels_; // the last whose textures are in the sets

    // With a work sink.
    std::vector<HostTransfer> transfers_; // since the last bin was handed over
    bool draw_goes_on_ = false;           // The bin is full within a draw.
    GeometryWork geometry_work_;          // of the draw under way
    struct RegistersSent {
        std::uint32_t writes = 0, words = 0;
    };
    RegistersSent registers_sent_; // since the last command
    SurfaceJournal journal_;       // with values, as contents_
    std::vector<std::shared_ptr<const SurfaceContent>> contents_;

    std::uint32_t draw_number_ = 0;
    std::uint32_t frame_ = 0;
    std::uint64_t samples_ = 0;
    bool samples_pending_ = false; // The bin holds draws that count samples.
    FragmentStatistics fragment_statistics_;
    HostStatistics host_statistics_;
};

} // namespace ffgpu
