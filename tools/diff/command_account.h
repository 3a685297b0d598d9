// AccountDevice: a device that draws on a FunctionalGpu and gives an account of each command: what
// the host wrote before it, what its stages made of it, and what the targets hold behind it. A
// command is carried out to its end before the next is taken, so that an account never mixes two.

#pragma once

#include "model/gpu/functional_gpu.h"
#include "tools/diff/account_sink.h"
#include "tools/diff/stage_account.h"
#include "tools/dump/contract_names.h"
#include "tools/frames/call_log.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

// A command that is no write of a register.
struct AccountedCommand {
    std::uint64_t number = 0; // from 0, over the whole input
    std::uint64_t frame = 0;
    std::optional<std::uint32_t> draw{}; // as PrimitiveKey counts them
    CallName call{};                     // of a trace
    std::string name{};                  // "draw", "clear"
};

class CommandAccounts {
public:
    virtual ~CommandAccounts() = default;

    // Where the entries of the command with this number go; null: nobody wants them.
    virtual AccountSink* begin(std::uint64_t number, std::uint64_t frame) = 0;
    virtual void end(const AccountedCommand& command) = 0;
};

class AccountDevice final : public Device {
public:
    AccountDevice(FunctionalGpu& gpu, CommandAccounts& accounts)
        : gpu_(gpu)
        , accounts_(accounts) {}

    void number_draws_from(std::uint32_t draw) { next_draw_ = draw; }
    void begin_frame(std::uint64_t frame) { frame_ = frame; }
    void name_calls(const CallLog* calls) { calls_ = calls; } // null: there are none

    std::uint64_t memory_size() const override { return gpu_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override { gpu_.finish(); }
    std::vector<const StatisticsGroup*> statistics() const override { return gpu_.statistics(); }

private:
    void open();
    void carry_out(const CommandReader& reader);
    void tell_register(const CommandReader& reader);
    void tell_text(AccountStage stage, const std::string& line);
    void tell_targets(const CommandReader& reader);
    void tell_surface(AccountPart part, const Surface& surface);
    void tell_counters();
    std::vector<std::uint64_t> counters() const;

    FunctionalGpu& gpu_;
    CommandAccounts& accounts_;
    const CallLog* calls_ = nullptr;
    ContractNames names_;
    std::uint64_t number_ = 0, frame_ = 0;
    std::uint32_t next_draw_ = 0;
    bool is_open_ = false; // begin() was called for command number_
    AccountSink* sink_ = nullptr;
    std::uint32_t uploads_ = 0, registers_ = 0; // of the command's so far
    std::vector<std::uint64_t> counters_before_;
    std::vector<std::byte> bytes_;
};

} // namespace ffgpu::tools
