#include "model/timing/host_bus.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

void HostBus::add(Command command, std::uint32_t register_writes, std::uint32_t register_words) {
    const std::uint64_t bytes = std::uint64_t{config_.command_bytes} +
                                std::uint64_t{register_writes} * config_.register_bytes +
                                std::uint64_t{register_words} * 4;
    command.bytes = command.command_bytes = bytes;
    commands_.push_back(std::move(command));
    wake();
}

void HostBus::enqueue(TimedScene& scene) {
    for (std::uint32_t i = 0; i < scene.work.draws.size(); ++i) {
        const PreparedDraw& draw = scene.work.draws[i];
        add({.token = DrawToken{&scene, i}}, draw.register_writes, draw.register_words);
        next_draw_ = draw.number + 1;
    }
}

void HostBus::enqueue(work::PreparedTransfer&& transfer) {
    const bool is_store = !transfer.tile_lines.empty();
    const CommandKind kind = is_store ? CommandKind::TileStore : command_kind(transfer.kind);
    const std::size_t entry = ports_.ledger.open(kind, transfer.number, 1);
    const std::uint32_t writes = transfer.register_writes, words = transfer.register_words;
    CommandToken token =
        std::make_shared<TransferCommand>(TransferCommand{std::move(transfer), entry});
    if (is_store) return add_without_bus(std::move(token));
    add({.token = std::move(token)}, writes, words);
}

void HostBus::enqueue(work::PreparedContent&& content) {
    add_without_bus(std::make_shared<const work::PreparedContent>(std::move(content)));
}

void HostBus::enqueue(std::vector<work::TransferLine>&& accessed) {
    add_without_bus(std::make_shared<const std::vector<work::TransferLine>>(std::move(accessed)));
}

// The machine's own.
void HostBus::add_without_bus(CommandToken token) {
    commands_.push_back({.token = std::move(token)});
    wake();
}

void HostBus::enqueue(const HostTransfer& transfer) {
    if (transfer.is_write && transfer.bytes == 0) return;
    const CommandKind kind = transfer.is_write ? CommandKind::HostWrite : CommandKind::HostRead;
    const Data data{transfer.is_write,
                    transfer.bytes,
                    Bursts(transfer.at, transfer.bytes),
                    ports_.ledger.open(kind, next_draw_, 1)};
    if (transfer.is_write) {
        Command upload;
        upload.data = data;
        commands_.push_back(std::move(upload));
        wake();
    } else {
        add({.token = DrainCommand{}, .data = data}, 0, 0);
    }
}

void HostBus::enqueue_frame_end() {
    ends_frame_ = true;
    add({.token = DrainCommand{.ends_frame = true}}, 0, 0);
}

Activity HostBus::step() {
    while (ports_.responses_in.can_pop()) { // The tickets of its reads are their bytes.
        const std::uint64_t bytes = ports_.responses_in.pop();
        arriving_ -= bytes;
        arrived_ += bytes;
    }
    if (now() < carried_at_) return Activity::Busy;
    budget_ = config_.bytes_per_cycle == 0 ? ~std::uint64_t{0} : config_.bytes_per_cycle;
    Activity reason = Activity::Idle;
    bool moved = false;
    while (!commands_.empty() && advance(reason))
        moved = true;
    if (starves()) ask_whether_to_wait();
    return moved ? Activity::Busy : reason;
}

bool HostBus::may_carry_all() const {
    if (config_.bytes_per_cycle == 0) return true;
    std::uint64_t left = config_.bytes_per_cycle;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (commands_[i].bytes > left) return false;
        left -= commands_[i].bytes;
    }
    return true;
}

// One thing that happens to the first command; false: nothing more in this cycle.
bool HostBus::advance(Activity& reason) {
    Command& command = commands_.front();
    if (command.bytes > 0) return carry(reason);
    if (!under_way_ && !std::holds_alternative<std::monostate>(command.token))
        return hand_over(reason);
    const bool drains = std::holds_alternative<DrainCommand>(command.token);
    if (drains && ports_.drained_in.can_pop()) {
        ports_.drained_in.pop();
        const bool ends_frame = std::get<DrainCommand>(command.token).ends_frame;
        command.token = {};
        if (!ends_frame) return true;
        ends_frame_ = false;
        end_command();
        return true;
    }
    if (drains) {
        reason = Activity::StalledOutput;
        return false;
    }
    return command.data.is_write ? upload(reason) : read_back(reason);
}

bool HostBus::carry(Activity& reason) {
    reason = Activity::Busy;
    if (budget_ == 0) return false;
    std::uint64_t& left = commands_.front().bytes;
    const std::uint64_t bytes = std::min(budget_, left);
    budget_ -= bytes;
    left -= bytes;
    if (left > 0) carry_on(left);
    return true;
}

// The cycles that carry nothing else than these bytes, all but the last.
void HostBus::carry_on(std::uint64_t& left) {
    const std::uint64_t cycles = (left - 1) / config_.bytes_per_cycle;
    left -= cycles * config_.bytes_per_cycle;
    carried_at_ = now() + cycles + 1;
}

bool HostBus::hand_over(Activity& reason) {
    const Command& command = commands_.front();
    if (!ports_.commands_out.can_push()) {
        reason = Activity::StalledOutput;
        return false;
    }
    ports_.commands_out.push(command.token);
    under_way_ = true;
    if (!std::holds_alternative<DrainCommand>(command.token)) end_command();
    return true;
}

// A burst goes to memory when all of it has come over the bus.
bool HostBus::upload(Activity& reason) {
    Command& command = commands_.front();
    Bursts& bursts = command.data.bursts;
    if (bursts.empty()) {
        ports_.ledger.end_part(command.data.entry, now());
        end_command();
        return true;
    }
    if (!under_way_) {
        under_way_ = true;
        command.bytes = bursts.bytes(config_.burst_bytes);
        return true;
    }
    if (!ports_.requests_out.can_push()) {
        reason = Activity::StalledRequests;
        return false;
    }
    ports_.requests_out.push({.address = bursts.address(),
                              .bytes = bursts.bytes(config_.burst_bytes),
                              .write = true,
                              .client = Client::Host});
    bursts.advance(config_.burst_bytes);
    under_way_ = false;
    return true;
}

bool HostBus::read_back(Activity& reason) {
    Command& command = commands_.front();
    Bursts& bursts = command.data.bursts;
    if (!bursts.empty() && ports_.requests_out.can_push()) {
        const std::uint32_t bytes = bursts.bytes(config_.burst_bytes);
        ports_.requests_out.push({.address = bursts.address(),
                                  .bytes = bytes,
                                  .write = false,
                                  .client = Client::Host,
                                  .ticket = bytes});
        arriving_ += bytes;
        bursts.advance(config_.burst_bytes);
        return true;
    }
    if (arrived_ > 0 && budget_ > 0) {
        command.bytes = std::exchange(arrived_, 0);
        return true;
    }
    if (bursts.empty() && arriving_ == 0 && arrived_ == 0) {
        ports_.ledger.end_part(command.data.entry, now());
        end_command();
        return true;
    }
    reason = Activity::StalledMemory;
    return false;
}

// What was on the bus is counted when all of it was: when it was told is in no figure.
void HostBus::end_command() {
    const Command& command = commands_.front();
    statistics_.command_bytes += command.command_bytes;
    (command.data.is_write ? statistics_.written_bytes : statistics_.read_bytes) +=
        command.data.bytes;
    commands_.pop_front();
    under_way_ = false;
}

} // namespace ffgpu::timing
