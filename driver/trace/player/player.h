// TracePlayer: carries out a trace's calls on the driver. The program's object names are kept (each
// glGen* call reserves the names that the program got), so that nothing needs a translation.
//
// Left out are calls that only ask, and with them the program's own look at GL errors.

#pragma once

#include "driver/trace/player/client_memory.h"
#include "driver/trace/player/gl_commands.h"
#include "driver/trace/player/window_system.h"
#include "driver/trace/reader/trace_reader.h"
#include "model/device/device.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ffgpu::trace {

// A picture that was handed over to the display, counted from 0.
struct ShownFrame {
    std::uint64_t number = 0;
    Surface picture; // Format None: there is none, its window was never drawn on.
};

class TracePlayer {
public:
    struct Options {
        // Lines about what the trace holds and we cannot do, each once.
        std::function<void(const std::string& line)> warn = [](const std::string&) {};
        // Reports each GL error as a warning, with the number of its call.
        bool report_errors = false;
        // Keeps the calls of the last frame for repeat_last_frame(), and leaves out what follows
        // it.
        bool keep_last_frame = false;
        // Of a pixel of every window: 1 or MaxSamples.
        unsigned samples = 1;
        // What a swap does to a window's back buffer.
        gl::SwapMode swap = gl::SwapMode::Copy;
        // Of the driver; its supersampling goes with one sample a pixel.
        gl::ControlPanel panel{};
        // Is told of each call before it is played; null: nobody is.
        std::function<void(const Call& call)> on_call{};
    };

    TracePlayer(Device& device, TraceReader& trace, Options options);

    // Plays up to the end of the next frame; nothing at the end of the trace, where also what
    // follows the last frame has been played. Throws InputError as the reader does.
    std::optional<ShownFrame> play_frame();

    // Plays the calls of the last frame again; no other may follow. False if they were not kept.
    bool repeat_last_frame();

    std::uint64_t calls_played() const { return calls_played_; }

private:
    using Special = void (TracePlayer::*)(const GlCommand* command, Call& call);

    // How a function of the trace is played.
    struct Action {
        enum class Kind : std::uint8_t { Unknown, Ignore, Plain, Special, WindowSystem };
        Kind kind = Kind::Unknown;
        const GlCommand* command = nullptr;
        TracePlayer::Special special = nullptr;
        WindowSystem::Handler handler = nullptr;
    };

    std::optional<ShownFrame> play_kept_frame();
    const Action& action_of(const Signature& signature);
    Action make_action(const std::string& name);
    static Special find_special(std::string_view name);
    void play(Call& call);
    std::uint64_t play_plain(const GlCommand& command, Call& call, bool again = false);
    void lose(const Call& call);
    void report_end();
    void report_error(const Call& call);
    // Once for each function of the trace.
    void warn_once(std::string_view name, const std::string& what);

    // Commands that need more than their arguments (special_calls.cpp).
    void generate_names(const GlCommand* command, Call& call);
    void generate_lists(const GlCommand* command, Call& call);
    void set_size(const GlCommand* command, Call& call);
    void set_array(const GlCommand* command, Call& call);
    void draw_arrays(const GlCommand* command, Call& call);
    void draw_elements(const GlCommand* command, Call& call);
    void multi_draw_arrays(const GlCommand* command, Call& call);
    void draw_checked(const GlCommand* command, Call& call, std::uint64_t vertices);
    void map_buffer(const GlCommand* command, Call& call);
    void copy_memory(const GlCommand* command, Call& call);
    void feedback_buffer(const GlCommand* command, Call& call);
    void select_buffer(const GlCommand* command, Call& call);
    void read_into_buffer(const GlCommand* command, Call& call);

    TraceReader& trace_;
    Options options_;
    WindowSystem windows_;
    std::vector<std::unique_ptr<Call>> last_frame_; // with keep_last_frame
    bool repeats_ = false;                          // that frame: no other will be read
    ClientMemory memory_;                           // may borrow of its calls
    Arguments arguments_;
    std::vector<Action> actions_; // by signature
    std::vector<bool> known_;     // Which of them have been looked up.
    std::set<std::string> warned_;
    bool had_context_ = false;
    std::string lost_draw_; // the first call that draws, but had no context
    std::uint64_t calls_played_ = 0;
    std::uint64_t frames_ = 0;
};

} // namespace ffgpu::trace
