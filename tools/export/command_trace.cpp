#include "tools/export/command_trace.h"

#include <utility>

namespace ffgpu::tools {
namespace {

using timing::DramOperation;
using timing::IssuedCommand;

bool is_column(DramOperation operation) {
    return operation >= DramOperation::RD && operation <= DramOperation::WRA;
}

// All columns of a request but the last.
DramOperation leaves_open(DramOperation operation) {
    if (operation == DramOperation::RDA) return DramOperation::RD;
    return operation == DramOperation::WRA ? DramOperation::WR : operation;
}

// Fields that the command does not have are empty.
void print(const IssuedCommand& command, TextWriter& out) {
    const std::string_view name =
        timing::DramOperationNames[static_cast<std::size_t>(command.operation)];
    out.print(FMT_COMPILE("{},{},{},"), command.at, command.channel, name);
    if (is_column(command.operation))
        out.print(FMT_COMPILE("{},{},{}\n"), command.bank, command.row, command.byte);
    else if (command.operation == DramOperation::ACT)
        out.print(FMT_COMPILE("{},{},\n"), command.bank, command.row);
    else if (command.operation == DramOperation::PRE)
        out.print(FMT_COMPILE("{},,\n"), command.bank);
    else
        out.print(FMT_COMPILE(",,\n"));
}

} // namespace

CommandTrace::CommandTrace(const timing::MemoryConfig& memory, TextWriter& out)
    : burst_bytes_(memory.burst_bytes())
    , spacing_(memory.column_spacing())
    , out_(out)
    , later_(memory.channels)
    , writer_(8 * Chunk) {
    writer_.push(1, [this] { out_.print(FMT_COMPILE("cycle,channel,command,bank,row,byte\n")); });
}

void CommandTrace::issued(const IssuedCommand& command) {
    Later& later = later_[command.channel];
    write_before(later, command.at);
    if (is_column(command.operation))
        later = command;
    else
        write(command);
}

void CommandTrace::write_before(Later& later, timing::MemoryCycle end) {
    for (; later && later->at < end; later->at += spacing_) {
        IssuedCommand burst = *later;
        if (later->bursts > 1) burst.operation = leaves_open(burst.operation);
        write(burst);
        later->byte += burst_bytes_;
        if (--later->bursts == 0) {
            later.reset();
            return;
        }
    }
}

void CommandTrace::write(const IssuedCommand& command) {
    ++counts_[static_cast<std::size_t>(command.operation)];
    chunk_.push_back(command);
    if (chunk_.size() >= Chunk) write_chunk();
}

void CommandTrace::write_chunk() {
    const std::size_t weight = 1 + chunk_.size(); // An argument may move what another one asks.
    writer_.push(weight, [this, chunk = std::exchange(chunk_, {})] {
        for (const IssuedCommand& command : chunk)
            print(command, out_);
    });
}

void CommandTrace::finish() {
    for (Later& later : later_)
        write_before(later, timing::NoCycle);
    write_chunk();
    writer_.push(1, [this] { out_.flush(); });
    writer_.drain();
}

} // namespace ffgpu::tools
