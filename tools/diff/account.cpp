#include "tools/diff/account.h"

#include "model/base/input_error.h"
#include "tools/diff/account_digest.h"
#include "tools/diff/command_account.h"
#include "tools/frames/frame_source.h"

#include <memory>

namespace ffgpu::tools {
namespace {

// A line of each command.
class DigestLines final : public CommandAccounts {
public:
    DigestLines(const FrameRange& frames, std::FILE* out)
        : frames_(frames)
        , out_(out) {}

    AccountSink* begin(std::uint64_t, std::uint64_t frame) override {
        digest_.reset();
        return frames_.contains(frame) ? &digest_ : nullptr;
    }

    void end(const AccountedCommand& command) override {
        fmt::print(out_,
                   "{}\t{}\t{}\t{}\t{}\t{}",
                   command.number,
                   command.frame,
                   command.draw ? std::to_string(*command.draw) : "-",
                   command.call.number,
                   command.call.name.empty() ? "-" : command.call.name,
                   command.name);
        for (std::size_t i = 0; i < AccountPart::Count; ++i) {
            const AccountDigest::Part& part = digest_.parts()[i];
            if (part.entries == 0) continue;
            fmt::print(
                out_, "\t{}={}:{:016x}", part_name(AccountPart::from(i)), part.entries, part.sum);
        }
        std::fputc('\n', out_);
    }

private:
    const FrameRange frames_;
    std::FILE* const out_;
    AccountDigest digest_;
};

// The entries of one command.
class EntryLines final : public CommandAccounts {
public:
    EntryLines(std::uint64_t command, const AccountParts& parts, std::FILE* out)
        : command_(command)
        , lines_(out, parts) {}

    bool is_done() const { return is_done_; }

    AccountSink* begin(std::uint64_t number, std::uint64_t) override {
        return number == command_ ? &lines_ : nullptr;
    }
    void end(const AccountedCommand&) override { is_done_ = true; }

private:
    const std::uint64_t command_;
    AccountLines lines_;
    bool is_done_ = false;
};

class Player {
public:
    Player(const std::string& input,
           const Stages& stages,
           const AccountQuestion& question,
           CommandAccounts& accounts)
        : gpu_({.stages = &stages})
        , device_(gpu_, accounts)
        , source_(open_frame_source(
              input,
              device_,
              {.warn = [](const std::string&) {},
               .samples = question.samples,
               .swap = question.swap,
               .on_call = [this](std::uint64_t number,
                                 std::string_view name) { calls_.begin(number, name); }})) {
        if (source_->has_calls()) device_.name_calls(&calls_);
        device_.number_draws_from(source_->prepare());
        next_ = source_->first_frame();
    }

    // Plays the next frame; false: there is none.
    bool play() {
        device_.begin_frame(next_);
        const std::optional<Frame> frame = source_->next();
        if (frame) next_ = frame->number + 1;
        return frame.has_value();
    }
    std::uint64_t next() const { return next_; }

private:
    CallLog calls_;
    FunctionalGpu gpu_;
    AccountDevice device_;
    std::unique_ptr<FrameSource> source_; // Plays on it.
    std::uint64_t next_ = 0;
};

void write_commands(const std::string& input,
                    const Stages& stages,
                    const AccountQuestion& question,
                    std::FILE* out) {
    DigestLines lines(question.frames, out);
    Player player(input, stages, question, lines);
    while (player.next() <= question.frames.last && player.play()) {
    }
    if (player.next() <= question.frames.first && question.frames.first > 0)
        throw InputError(missing_frames(question.frames, input, player.next()));
}

void write_entries(const std::string& input,
                   const Stages& stages,
                   const AccountQuestion& question,
                   std::FILE* out) {
    EntryLines lines(*question.command, question.parts, out);
    Player player(input, stages, question, lines);
    while (!lines.is_done() && player.play()) {
    }
    if (!lines.is_done())
        throw InputError(fmt::format("{}: has no command {}", input, *question.command));
}

} // namespace

void write_account(const std::string& input,
                   const Stages& stages,
                   const AccountQuestion& question,
                   std::FILE* out) {
    fmt::print(out, "{}\n", AccountHeader);
    try {
        if (question.command)
            write_entries(input, stages, question, out);
        else
            write_commands(input, stages, question, out);
        fmt::print(out, "end\n");
    } catch (const InputError& error) {
        fmt::print(out, "error\t{}\n", error.what());
    }
    std::fflush(out);
}

void draw_up_to(const std::string& input,
                const Stages& stages,
                AccountQuestion question,
                std::uint64_t command) {
    question.command = command;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::fopen("/dev/null", "w"),
                                                                  std::fclose);
    write_account(input, stages, question, nowhere.get());
}

} // namespace ffgpu::tools
