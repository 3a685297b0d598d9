// HostBus: what the host sends, in its order, bytes_per_cycle at a time. Draws, clears and copies,
// with the registers that were written before them, go on to the command processor. Uploads are
// written to memory as they come over the bus; what follows them waits until the last is on its
// way. A read by the driver waits for the machine to be drained, reads memory, and brings the data
// back over the same bus; the host sends nothing meanwhile.

#pragma once

#include "model/base/ring.h"
#include "model/timing/bursts.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/host_command.h"
#include "model/timing/request_port.h"
#include "model/timing/unit.h"

#include <vector>

namespace ffgpu::timing {

class HostStatistics : public StatisticsGroup {
public:
    Counter& command_bytes =
        count("host_command_bytes", "bytes", "of commands and register writes on the bus");
    Counter& written_bytes =
        count("host_written_bytes", "bytes", "that the driver wrote to device memory");
    Counter& read_bytes =
        count("host_read_bytes", "bytes", "that the driver read from device memory");
};

class HostBus final : public Unit {
public:
    struct Ports {
        Channel<CommandToken>& commands_out;
        Channel<Drained>& drained_in;
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
        CommandLedger& ledger;
    };

    HostBus(sc_core::sc_module_name name,
            const Clock& clock,
            const TimingConfig& config,
            const Ports& ports)
        : Unit(name, clock)
        , config_(config.host)
        , ports_(ports)
        , most_in_a_cycle_(std::size_t{config.host.queue} + config.memory.client_queue + 1) {}

    // The host's side; called while the simulation is paused.
    void enqueue(TimedScene& scene);
    void enqueue(work::PreparedTransfer&& transfer);
    void enqueue(const HostTransfer& transfer);
    void enqueue(work::PreparedContent&& content);
    void enqueue(std::vector<work::TransferLine>&& accessed);
    void enqueue_frame_end();
    // What is left to send could end within a cycle, in which the bus would go on to what the host
    // has not told yet: the clock must not go on without the host.
    bool starves() const {
        if (ends_frame_) return commands_.empty();
        return commands_.size() <= most_in_a_cycle_ && may_carry_all();
    }

    std::string state() const override;
    const HostStatistics& statistics() const { return statistics_; }

private:
    // Bytes of memory that are written or read.
    struct Data {
        bool is_write = true;
        std::uint64_t bytes = 0;
        Bursts bursts;
        std::size_t entry = 0; // of the ledger
    };
    struct Command {
        std::uint64_t bytes = 0; // still to come over the bus, before anything comes of it
        std::uint64_t command_bytes = 0;
        CommandToken token; // none: data alone
        Data data{};
    };

    Activity step() override;
    Cycle next_work(Activity last) const override {
        return now() < carried_at_ ? carried_at_ : Unit::next_work(last);
    }
    void add_without_bus(CommandToken token);
    void add(Command command, std::uint32_t register_writes, std::uint32_t register_words);
    // In a cycle, but for what is uploaded.
    bool may_carry_all() const;
    bool advance(Activity& reason);
    bool carry(Activity& reason);
    void carry_on(std::uint64_t& left);
    bool hand_over(Activity& reason);
    bool upload(Activity& reason);
    bool read_back(Activity& reason);
    void end_command();

    const HostConfig config_;
    const Ports ports_;
    HostStatistics statistics_;
    Ring<Command> commands_;
    // Commands that can end in a cycle: handed over, uploads' last bursts, the end of a read.
    const std::size_t most_in_a_cycle_;
    bool ends_frame_ = false; // The last command does; the host tells nothing more before its end.
    std::uint32_t next_draw_ = 0; // number of the draw that a transfer precedes

    std::uint64_t budget_ = 0; // bytes that the bus still carries in this cycle
    Cycle carried_at_ = 0;     // it carries the first command's bytes alone before
    // Of the first command:
    bool under_way_ = false; // It was handed over, or its next burst is on the bus.
    std::uint64_t arriving_ = 0, arrived_ = 0; // bytes that the driver reads
};

} // namespace ffgpu::timing
