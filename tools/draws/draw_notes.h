// DrawNotes: what is known of draws when they are submitted and is not in their work. Written on
// the thread that submits, taken on the one that reads the work.

#pragma once

#include "tools/draws/draw_watch.h"
#include "tools/frames/call_log.h"

#include <cstdint>
#include <map>
#include <mutex>

namespace ffgpu::tools {

struct DrawNote {
    WatchedDraw draw;
    CallName call; // of a trace: that gave its first vertex; else without a name
};

class DrawNotes {
public:
    void add(const DrawNote& note) {
        const std::lock_guard lock(mutex_);
        notes_[note.draw.number] = note;
    }

    // Of the draw, or of none; those before it are forgotten.
    DrawNote take(std::uint32_t draw) {
        const std::lock_guard lock(mutex_);
        notes_.erase(notes_.begin(), notes_.lower_bound(draw));
        const auto found = notes_.find(draw);
        return found == notes_.end() ? DrawNote{} : found->second;
    }

private:
    std::mutex mutex_;
    std::map<std::uint32_t, DrawNote> notes_;
};

} // namespace ffgpu::tools
