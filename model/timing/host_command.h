// What the host sends, and what of it the command processor reads.

#pragma once

#include "model/timing/tokens.h"
#include "model/work/machine_order.h"

#include <memory>
#include <variant>
#include <vector>

namespace ffgpu::timing {

// A clear or a copy.
struct TransferCommand {
    work::PreparedTransfer work;
    std::size_t entry = 0; // of the ledger
};

// The pipe is to be empty and the caches written back: before the driver reads, and at the end of a
// frame, where the memory has to be done, too.
struct DrainCommand {
    bool ends_frame = false;
};

// What a target holds, and the lines of targets that the host is about to read or write: for the
// states of their blocks. Nothing of them is on the bus.
using ContentCommand = std::shared_ptr<const work::PreparedContent>;
using HostAccessCommand = std::shared_ptr<const std::vector<work::TransferLine>>;

using CommandToken = std::variant<std::monostate,
                                  DrawToken,
                                  std::shared_ptr<TransferCommand>,
                                  DrainCommand,
                                  ContentCommand,
                                  HostAccessCommand>;
std::string key_of(const CommandToken& command);

// What CommandProcessor tells the host's bus: a DrainCommand is carried out.
struct Drained {};

} // namespace ffgpu::timing
