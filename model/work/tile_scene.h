// TileScene: what a tile-based machine gathers before it draws: draws, images and clears of the
// same targets, in their order.

#pragma once

#include "model/work/deferred_stores.h"
#include "model/work/prepared_work.h"
#include "model/work/target_clear.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ffgpu::work {

// The samples of a target, averaged on their way to another surface.
struct TileResolve {
    std::size_t target = 0; // index into GatheredScene::targets
    TileTarget destination;
};

// A clear of the targets that there are.
struct TileClear {
    Rectangle rectangle;
    std::vector<TargetClear> targets; // as GatheredScene::targets
};

// Of each command of PreparedScene::draws.
struct TileCommand {
    // Bytes of a sample of the depth target: read, written by fragments that pass, and by others.
    std::uint32_t depth_read = 0, depth_written = 0, stencil_written = 0;
    bool reads_color = false, writes_color = false;
    std::optional<TileClear> clear;
    bool is_background = false; // a clear of whole targets before all draws
};

struct GatheredScene {
    const std::vector<TileTarget>& targets;
    const std::vector<TileCommand>& commands;
    const std::optional<TileResolve>& resolve;
};

class TileScene {
public:
    TileScene(const WorkConfig& config, AddressMap& addresses)
        : config_(config)
        , addresses_(addresses) {}

    bool empty() const { return scene_.draws.empty(); }
    // Of its commands; the next ones must have the same while it is not empty.
    const Targets& targets() const { return targets_; }

    void draw(const WholeCommand& command);
    void clear(const WorkDraw& clear);
    // A copy of all of a multisampled target, which can be made of what is on chip; nothing where
    // the copy is none.
    bool resolve(const WorkDraw& copy);

    // The scene, with its plan; it is empty then.
    PreparedScene take(DeferredStores& deferred);

private:
    void begin(const Targets& targets);
    PreparedDraw& add_command(const WorkDraw& command);

    const WorkConfig& config_;
    AddressMap& addresses_;
    PreparedScene scene_;
    Targets targets_;
    std::vector<TileTarget> places_; // of targets_ that there are; depth is the last
    std::vector<TileCommand> commands_;
    std::optional<TileResolve> resolve_;
};

} // namespace ffgpu::work
