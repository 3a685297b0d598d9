#include "driver/trace/player/player.h"

#include "driver/context/current.h"
#include "driver/trace/player/names.h"
#include "model/base/check.h"

#include <utility>

namespace ffgpu::trace {
namespace {

// What does not change any state. glGetTexImage and glReadPixels do where a buffer object takes
// their result.
bool only_asks(std::string_view name) {
    return name.starts_with("glGet") || name.starts_with("glIs") ||
           name.starts_with("glAreTexturesResident") ||
           name.starts_with("glCheckFramebufferStatus");
}

bool has_buffer(OffsetInto into, const gl::Context& context) {
    const gl::ClientState& client = context.client;
    switch (into) {
    case OffsetInto::VertexBuffer:
        return client.buffers.array != nullptr;
    case OffsetInto::IndexBuffer:
        return client.arrays.object->element_buffer != nullptr;
    case OffsetInto::PixelUnpack:
        return client.buffers.pixel_unpack != nullptr;
    case OffsetInto::PixelPack:
        return client.buffers.pixel_pack != nullptr;
    default:
        return false;
    }
}

const char* error_name(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW:
        return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW:
        return "GL_STACK_UNDERFLOW";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "a GL error";
    }
}

} // namespace

TracePlayer::TracePlayer(Device& device, TraceReader& trace, Options options)
    : trace_(trace)
    , options_(std::move(options))
    , windows_(device, options_.samples, options_.swap, options_.panel) {}

std::optional<ShownFrame> TracePlayer::play_frame() {
    if (options_.keep_last_frame) return play_kept_frame();
    while (Call* const call = trace_.next()) {
        play(*call);
        ++calls_played_;
        if (const std::optional<Surface> shown = windows_.take_shown()) [[unlikely]]
            return ShownFrame{frames_++, *shown};
    }
    report_end();
    return std::nullopt;
}

// Reads a frame to its end before it plays it: what follows the last one, where programs destroy
// their contexts, must not happen while that frame is to be repeated.
std::optional<ShownFrame> TracePlayer::play_kept_frame() {
    check(!repeats_, "a frame is read after the last one was repeated");
    std::vector<std::unique_ptr<Call>> frame;
    while (const Call* const call = trace_.next()) {
        const bool ends_frame = WindowSystem::hands_over(call->name());
        frame.push_back(trace_.take());
        if (!ends_frame) continue;
        last_frame_ = std::move(frame);
        for (const std::unique_ptr<Call>& kept : last_frame_)
            play(*kept);
        calls_played_ += last_frame_.size();
        return ShownFrame{frames_++, windows_.take_shown().value_or(Surface{})};
    }
    report_end();
    return std::nullopt;
}

bool TracePlayer::repeat_last_frame() {
    repeats_ = true;
    constexpr std::size_t Soon = 4;
    for (std::size_t i = 0; i < last_frame_.size(); ++i) {
        if (i + 2 * Soon < last_frame_.size()) {
            last_frame_[i + 2 * Soon]->prefetch();
            last_frame_[i + Soon]->prefetch_values();
        }
        play(*last_frame_[i]);
    }
    windows_.take_shown();
    return !last_frame_.empty();
}

void TracePlayer::play(Call& call) {
    if (options_.on_call) [[unlikely]]
        options_.on_call(call);
    const Action& action = action_of(call.signature());
    switch (action.kind) {
    case Action::Kind::Unknown:
    case Action::Kind::Ignore:
        return;
    case Action::Kind::WindowSystem:
        windows_.enter_thread(call.thread());
        return (windows_.*action.handler)(call);
    case Action::Kind::Plain:
    case Action::Kind::Special:
        windows_.enter_thread(call.thread());
        if (!gl::current_context()) return lose(call);
        had_context_ = true;
        if (action.kind == Action::Kind::Plain) {
            play_plain(*action.command, call, repeats_);
        } else {
            (this->*action.special)(action.command, call);
        }
        if (options_.report_errors) report_error(call);
    }
}

std::uint64_t TracePlayer::play_plain(const GlCommand& command, Call& call, bool again) {
    const gl::Context& context = *gl::current_context();
    arguments_.begin(
        call, context, command.array_size, has_buffer(command.offset_into, context), again);
    const std::uint64_t result = command.call(command.function, arguments_);
    if (arguments_.refused())
        warn_once(call.name(),
                  "call " + std::to_string(call.number()) + " " + std::string(call.name()) +
                      ": left out: it reads too much memory");
    return result;
}

const TracePlayer::Action& TracePlayer::action_of(const Signature& signature) {
    if (signature.id >= known_.size()) {
        known_.resize(signature.id + 1);
        actions_.resize(signature.id + 1);
    }
    if (!known_[signature.id]) {
        known_[signature.id] = true;
        actions_[signature.id] = make_action(signature.name);
    }
    return actions_[signature.id];
}

TracePlayer::Action TracePlayer::make_action(const std::string& name) {
    using Kind = Action::Kind;
    Action action;
    action.command = find_gl_command(name);
    if ((action.handler = WindowSystem::find(name))) {
        action.kind = Kind::WindowSystem;
    } else if ((action.special = find_special(name)) && (action.command || name == "memcpy")) {
        action.kind = Kind::Special;
    } else if (only_asks(name) || WindowSystem::is_harmless(name)) {
        action.kind = Kind::Ignore;
    } else if (action.command) {
        action.kind = Kind::Plain;
    } else {
        warn_once(name, "not supported yet: " + name);
    }
    return action;
}

// As GL does without a context: nothing.
void TracePlayer::lose(const Call& call) {
    if (lost_draw_.empty() && draws(call.name()))
        lost_draw_ = "call " + std::to_string(call.number()) + " " + std::string(call.name());
}

// apitrace records one window system at a time, GLX where it is not told.
void TracePlayer::report_end() {
    constexpr const char* Hint = "; of programs on EGL a trace is made by apitrace trace -a egl "
                                 "PROGRAM";
    if (calls_played_ == 0) options_.warn(std::string("the trace holds no calls") + Hint);
    if (had_context_ || lost_draw_.empty()) return;
    options_.warn(lost_draw_ + " draws, but no call makes a context current: nothing is drawn" +
                  Hint);
}

void TracePlayer::report_error(const Call& call) {
    const GLenum error = gl::current_context()->take_error();
    if (error == GL_NO_ERROR) return;
    options_.warn("call " + std::to_string(call.number()) + " " + std::string(call.name()) + ": " +
                  error_name(error));
}

void TracePlayer::warn_once(std::string_view name, const std::string& what) {
    if (warned_.insert(std::string(name)).second) options_.warn(what);
}

} // namespace ffgpu::trace
