// MachineOrder: whole commands as a machine of a given shape carries them out: scenes, transfers
// and ends of frames, one after the other, with addresses.
//
// An immediate machine makes a scene of each draw. A tile-based one gathers draws into a scene
// until
//   - the targets change, or a frame ends;
//   - a copy comes: it is done on surfaces in memory, but for the resolve of a whole target;
//   - the driver reads or writes bytes of the scene's targets;
//   - a draw reads a texture or an image that the scene draws into.
// All of these are what the application did: nothing of how the host drew can end a scene. Clears
// are part of a scene.
//
// Of an immediate machine's draws of many quads these can be told in parts, behind what comes next.

#pragma once

#include "model/work/draw_preparation.h"
#include "model/work/drawn_texels.h"
#include "model/work/prepared_work.h"
#include "model/work/surface_fill.h"
#include "model/work/surface_lines.h"
#include "model/work/tile_scene.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

namespace ffgpu::work {

// A line that is read, or of which bytes are written past its cache.
struct TransferLine {
    bool depth = false; // of the depth cache's lines; else of the colour cache's
    bool write = true;
    WrittenLine line;
    bool whole = false; // written: what is written of a pixel is, of all the line's pixels
};

// A clear or a copy; or what bins of a tile-based machine's scenes have to store after all.
struct PreparedTransfer {
    WorkKind kind = WorkKind::Clear;
    std::uint32_t number = 0;
    bool writes_back_caches = false;                       // before it
    std::uint32_t register_writes = 0, register_words = 0; // as WorkDraw has them
    std::vector<TransferLine> lines{};
    std::vector<SurfaceFill> fills{};     // a clear's, of the targets in turn
    std::vector<PlacedLine> tile_lines{}; // not empty: the third
};

// What a target holds before the commands from here on (with values).
struct PreparedContent {
    bool depth = false;
    PlacedLevel place;
    std::shared_ptr<const SurfaceContent> content;
};

class MachineSink {
public:
    virtual ~MachineSink() = default;
    virtual void scene(PreparedScene&& scene) = 0;
    // The next quads of the first scene that waits for some: of an immediate machine, where it
    // takes them in parts. Other scenes, and all else but the frame's end, may come before them.
    virtual void part(PreparedPart&& /*part*/) {}
    virtual bool takes_parts() const { return false; }
    virtual void transfer(PreparedTransfer&& transfer) = 0;
    virtual void host_transfer(const HostTransfer& transfer) = 0;
    // Before it, where parts are left: nothing else of the frame comes any more.
    virtual void end_commands() {}
    virtual void end_frame(std::uint32_t frame) = 0;
    // Texels changed where they lie: those of these lines of the texel cache, in rising order.
    virtual void texels_rewritten(std::vector<std::uint64_t>&& /*lines*/) {}
    virtual void content(PreparedContent&& /*content*/) {}
    // The host reads or writes these lines of targets whose content was told.
    virtual void host_access(std::vector<TransferLine>&& /*lines*/) {}
};

class MachineOrder final : public CommandSink {
public:
    MachineOrder(const WorkConfig& config, MachineSink& out)
        : config_(config)
        , out_(out)
        , addresses_(config.texel_cache)
        , tiles_(config_, addresses_)
        , deferred_(config.raster.bin_size) {}

    void command(std::shared_ptr<const WholeCommand> command) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override;
    void host_transfer(const HostTransfer& transfer) override;
    void end_frame(std::uint32_t frame) override;

    // Tells the sink a part of the quads that it waits for; false: it waits for none. For who has
    // nothing to command.
    bool tell_part();
    // All of them.
    void tell_parts() {
        while (tell_part()) {
        }
    }

    // The colour surface that was drawn, cleared or copied into last: what a screen would show.
    // None yet: no bytes.
    PlacedLevel shown();

    // Where a colour surface lies, and the depths that were drawn or cleared with it last. Of what
    // no command has drawn on, and where there are no depths: no bytes.
    PlacedLevel place_of(const Surface& color, bool depth);

    // Where the textures and surfaces of the commands so far lie.
    AddressMap& addresses() { return addresses_; }

private:
    // A draw whose quads are not all told.
    struct Untold {
        std::shared_ptr<const WholeCommand> command;
        DrawPreparation draw;
    };

    void note_shown(const WorkDraw& draw);
    void draw(std::shared_ptr<const WholeCommand> command);
    bool is_tile_based() const { return config_.raster.architecture == Architecture::TileBased; }
    void gather(const WholeCommand& command);
    void clear(const WorkDraw& draw);
    void copy(const WorkDraw& draw);
    void texels_drawn(const WholeCommand& command);
    RewrittenLevel rewritten() const;
    void tell_rewritten(std::vector<std::uint64_t>&& lines);
    void end_scene();
    void access(const HostTransfer& transfer);
    const CacheShape& shape(bool depth) const {
        return depth ? config_.depth_cache : config_.color_cache;
    }
    void clear_lines(const SurfaceFill& fill,
                     bool depth,
                     PixelBytes pixel,
                     PreparedTransfer& transfer) const;
    void store_due();
    bool scene_draws_into(std::uint64_t at, std::uint64_t bytes) const;
    bool reads_scene(const WholeCommand& command) const;

    const WorkConfig config_;
    MachineSink& out_;
    AddressMap addresses_;
    DrawnTexels drawn_texels_{addresses_};
    std::vector<Surface> known_; // whose content was told
    Surface shown_;
    std::map<DeviceAddress, Targets> drawn_; // by the first colour target
    TileScene tiles_;                        // what a tile-based machine has gathered
    DeferredStores deferred_;
    std::uint32_t last_number_ = 0; // of a command
    std::deque<Untold> untold_;
    std::size_t untold_quads_ = 0;
};

} // namespace ffgpu::work
