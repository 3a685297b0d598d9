// CommandLedger: whose cycles they were. Every command of a frame is listed, and every cycle of the
// frame belongs to one of them: the cycles since the last entry go to
//   - the draw of a quad, where the quad retires;
//   - a draw whose last piece of work ends in another way (a quad that dies, a primitive that
//     leaves no quad), if no command before it is still under way;
//   - a clear, a copy or a host transfer, where its last line leaves the command processor;
//   - the end of the frame: what is left, which is the write-back of the caches.
// Where several commands could have them in one cycle the first has, whoever of the units told it
// first.

#pragma once

#include "model/packets/work_stream.h"
#include "model/timing/frame_waits.h"
#include "model/timing/memory_request.h"
#include "model/timing/resource.h"
#include "model/work/draw_shape.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ffgpu::timing {

enum class CommandKind : std::uint8_t {
    Draw,
    Image,
    Clear,
    Copy,
    HostWrite,
    HostRead,
    TileStore, // of bins of a tile-based machine, in the end needed by what comes next
    FrameEnd
};
inline constexpr std::array<std::string_view, 8> CommandKindNames{
    "draw", "image", "clear", "copy", "host_write", "host_read", "tile_store", "frame_end"};

constexpr CommandKind command_kind(WorkKind kind) {
    switch (kind) {
    case WorkKind::Draw:
        return CommandKind::Draw;
    case WorkKind::Image:
        return CommandKind::Image;
    case WorkKind::Clear:
        return CommandKind::Clear;
    case WorkKind::Copy:
        break;
    }
    return CommandKind::Copy;
}

// Bytes that memory has moved.
struct MovedBytes {
    std::uint64_t read = 0, written = 0;

    bool operator==(const MovedBytes&) const = default;
};

struct CommandCycles {
    CommandKind kind = CommandKind::Draw;
    std::uint32_t number = 0; // WorkDraw::number; of a host transfer: of the draw that it precedes
    std::uint64_t cycles = 0;
    WaitedCycles waited{};   // whose sum they are; none where nobody looked
    Saved saved{};           // that it would have taken less without each resource, about
    work::DrawShape shape{}; // of a draw or an image
    std::array<MovedBytes, Clients> moved{}; // in its cycles, whoever asked for them before

    // Without which it would have taken the fewest cycles; of two the first. Where none is saved
    // the one that it waited for most.
    Resource bottleneck() const {
        auto most_saved = Resource{};
        for (std::size_t i = 1; i < Resources; ++i)
            if (const auto each = static_cast<Resource>(i); saved[each] > saved[most_saved])
                most_saved = each;
        if (saved[most_saved] > 0) return most_saved;
        return static_cast<Resource>(std::max_element(waited.begin(), waited.end()) -
                                     waited.begin());
    }
    // "none" where it waited for nothing, or nobody looked.
    std::string_view bottleneck_name() const {
        const Resource resource = bottleneck();
        const bool found = saved[resource] > 0 || waited[static_cast<std::size_t>(resource)] > 0;
        return found ? ResourceNames[static_cast<std::size_t>(resource)] : "none";
    }
    std::uint64_t bottleneck_cycles() const {
        return waited[static_cast<std::size_t>(bottleneck())];
    }
};

class CommandLedger {
public:
    // A command that ends with the last of `parts`; returns its entry.
    std::size_t open(CommandKind kind, std::uint32_t number, std::uint64_t parts);
    void set_shape(std::size_t entry, const work::DrawShape& shape) {
        entries_[entry].listed.shape = shape;
    }

    void retire(std::size_t entry, std::uint64_t now);   // A part that is charged for the time.
    void end_part(std::size_t entry, std::uint64_t now); // Any other part.

    // Memory has read or written what was asked for: bytes of whoever is charged for the cycle.
    void moved(const MemoryRequest& request, std::uint64_t now);

    // The cycle is over: the entry that was charged for it, or Nobody.
    static constexpr std::size_t Nobody = ~std::size_t{0};
    std::size_t charged(std::uint64_t now) const { return now == cycle_ ? charged_ : Nobody; }

    // All commands have ended: their cycles, whose sum is that of the cycles since the last call.
    std::vector<CommandCycles> end_frame(std::uint64_t now, const FrameWaits& waits);

private:
    struct Entry {
        CommandCycles listed;
        std::uint64_t parts_left = 0;
    };

    void begin_cycle(std::uint64_t now);
    void charge(std::size_t entry, std::uint64_t now);
    void count(Entry& entry);
    void note_charge();
    void give_moved(CommandCycles& to);
    void explain(const FrameWaits& waits);

    std::vector<Entry> entries_; // of the frame, in the order of the commands
    std::size_t oldest_ = 0;     // that is under way
    std::uint64_t charged_until_ = 0;
    std::uint64_t frame_begin_ = 0;
    // Whose the cycles were, up to and including `end`, since the one before.
    struct Charge {
        std::uint64_t end = 0;
        std::size_t entry = 0;
    };
    std::vector<Charge> charges_;
    std::array<MovedBytes, Clients> moved_{}; // since the last charge that is sure
    bool any_moved_ = false;
    // Of the cycle of the last call:
    std::uint64_t cycle_ = 0;
    std::size_t oldest_before_ = 0; // oldest_ when it began
    std::size_t charged_ = Nobody;  // who has the cycles up to here; Nobody: nobody was charged
    std::uint64_t charge_ = 0;      // and how many
};

} // namespace ffgpu::timing
