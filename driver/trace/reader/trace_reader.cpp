#include "driver/trace/reader/trace_reader.h"

#include "model/base/input_error.h"

#include <algorithm>

namespace ffgpu::trace {
namespace {

enum Event : std::uint8_t { EnterEvent, LeaveEvent };

enum Detail : std::uint8_t {
    EndDetail,
    ArgumentDetail,
    ResultDetail,
    ThreadDetail, // version < 4
    BacktraceDetail,
    FlagsDetail,
};

enum FrameDetail : std::uint8_t {
    FrameEnd,
    FrameModule,
    FrameFunction,
    FrameFile,
    FrameLine,
    FrameOffset,
};

constexpr std::uint64_t MaxArguments = 256;
constexpr std::size_t MaxPending = 4096; // One a thread is usual.

} // namespace

TraceReader::TraceReader(std::string path)
    : path_(std::move(path))
    , stream_(open_container(path_)) {
    try {
        read_header();
    } catch (const Damage& damage) {
        throw InputError(path_ + ": in the header: " + damage.what);
    }
}

TraceReader::~TraceReader() = default;

void TraceReader::rewind() {
    stream_.rewind();
    next_number_ = 0;
    if (delivered_) spare_.push_back(std::move(delivered_));
    std::ranges::move(pending_, std::back_inserter(spare_));
    pending_.clear();
    signatures_ = {};
    frames_ = {};
    try {
        read_header();
    } catch (const Damage& damage) {
        throw InputError(path_ + ": in the header: " + damage.what);
    }
}

void TraceReader::read_header() {
    version_ = stream_.uint();
    if (version_ == 'a') // Snappy's 'at', as a file that was packed once more begins.
        throw InputError(path_ + ": is a trace that was compressed once more; unpack it first");
    if (version_ > MaxTraceVersion)
        throw InputError(path_ + ": trace version " + std::to_string(version_) +
                         "; versions up to " + std::to_string(MaxTraceVersion) + " can be read");
    values_.emplace(stream_, version_);
    if (version_ < 6) return;
    stream_.uint(); // The semantic version.
    while (!values_->parse_name().empty())
        values_->parse_name();
}

Call* TraceReader::next() {
    try {
        return next_or_damage();
    } catch (const Damage& damage) {
        throw InputError(path_ + ": " + place() + ": " + damage.what);
    }
}

std::string TraceReader::place() const {
    std::string place = "byte " + std::to_string(stream_.position()) + " (uncompressed)";
    if (!pending_.empty())
        return place + ", in call " + std::to_string(pending_.back()->number()) + " " +
               std::string(pending_.back()->name());
    return place + ", before call " + std::to_string(next_number_);
}

Call* TraceReader::next_or_damage() {
    if (delivered_) spare_.push_back(std::move(delivered_));
    for (;;) {
        if (stream_.at_end()) {
            if (!pending_.empty()) throw Damage{"the trace ends before the call does"};
            return nullptr;
        }
        const std::uint8_t event = stream_.byte();
        if (event == EnterEvent) {
            parse_enter();
        } else if (event == LeaveEvent) {
            return parse_leave();
        } else {
            throw Damage{"expected an event (0 or 1), found " + std::to_string(event)};
        }
    }
}

void TraceReader::parse_enter() {
    const std::uint64_t thread = version_ >= 4 ? stream_.uint() : 0;
    const Signature& signature = parse_signature();
    parse_details(begin_call(signature, static_cast<std::uint32_t>(thread)));
}

Call& TraceReader::begin_call(const Signature& signature, std::uint32_t thread) {
    if (pending_.size() >= MaxPending) throw Damage{"expected calls to be left, found only enters"};
    if (spare_.empty()) spare_.push_back(std::make_unique<Call>());
    pending_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    pending_.back()->reset(signature, next_number_++, thread);
    return *pending_.back();
}

Call* TraceReader::parse_leave() {
    const std::uint64_t number = stream_.uint();
    const auto left = std::find_if(pending_.rbegin(), pending_.rend(), [&](const auto& call) {
        return call->number() == number;
    });
    if (left == pending_.rend())
        throw Damage{"expected the end of a call that was entered, found call " +
                     std::to_string(number)};
    parse_details(**left);
    delivered_ = std::move(*left);
    pending_.erase(std::next(left).base());
    return delivered_.get();
}

// Names are shown to people: a damaged one must not get to a terminal.
std::string TraceReader::parse_identifier() {
    std::string name = values_->parse_name();
    const auto is_shown = [](char letter) { return letter >= ' ' && letter <= '~'; };
    if (!std::ranges::all_of(name, is_shown))
        throw Damage{"expected a name's letters, found other bytes"};
    return name;
}

const Signature& TraceReader::parse_signature() {
    const std::uint64_t id = stream_.uint();
    if (const Signature* known = signatures_.find(id)) return *known;
    auto fresh = std::make_unique<Signature>();
    fresh->id = static_cast<std::uint32_t>(id);
    fresh->name = parse_identifier();
    const std::uint64_t arguments = stream_.uint();
    if (arguments > MaxArguments)
        throw Damage{"expected at most " + std::to_string(MaxArguments) + " arguments of " +
                     fresh->name + ", found " + std::to_string(arguments)};
    for (std::uint64_t i = 0; i < arguments; ++i)
        fresh->arguments.push_back(parse_identifier());
    return signatures_.define(id, std::move(fresh));
}

void TraceReader::parse_details(Call& call) {
    for (;;) {
        const std::uint8_t detail = stream_.byte();
        switch (detail) {
        case EndDetail:
            return;
        case ArgumentDetail:
            parse_argument(call);
            break;
        case ResultDetail:
            call.result_at_ = static_cast<std::uint32_t>(call.values_.size());
            values_->parse(call);
            break;
        case ThreadDetail:
            call.thread_ = static_cast<std::uint32_t>(stream_.uint());
            break;
        case BacktraceDetail:
            parse_backtrace();
            break;
        case FlagsDetail:
            call.flags_ = static_cast<std::uint32_t>(stream_.uint());
            break;
        default:
            throw Damage{"expected a detail of a call (0 to 5), found " + std::to_string(detail)};
        }
    }
}

void TraceReader::parse_argument(Call& call) {
    const std::uint64_t index = stream_.uint();
    if (index >= call.argument_at_.size())
        throw Damage{"expected one of " + std::to_string(call.argument_at_.size()) +
                     " arguments, found argument " + std::to_string(index)};
    const auto at = static_cast<std::uint32_t>(call.values_.size());
    call.argument_at_[index] = at;
    if (index == call.in_order_ && at == index)
        ++call.in_order_;
    else if (index < call.in_order_) // once more
        call.in_order_ = static_cast<std::uint32_t>(index);
    values_->parse(call);
}

// Where the program called from: read and dropped.
void TraceReader::parse_backtrace() {
    for (std::uint64_t left = stream_.uint(); left > 0; --left) {
        const std::uint64_t id = stream_.uint();
        if (frames_.find(id)) continue;
        frames_.define(id, std::make_unique<StackFrame>());
        for (;;) {
            const std::uint8_t detail = stream_.byte();
            if (detail == FrameEnd) break;
            if (detail <= FrameFile) {
                values_->parse_name();
            } else if (detail <= FrameOffset) {
                stream_.uint();
            } else {
                throw Damage{"expected a detail of a stack frame (0 to 5), found " +
                             std::to_string(detail)};
            }
        }
    }
}

} // namespace ffgpu::trace
