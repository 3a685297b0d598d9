// What goes out on the command bus of a DRAM channel, for whoever wants to see it.

#pragma once

#include "model/timing/memory/lost_cycles.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

// Under the names of the data sheets: a column with an `A` closes its row behind itself, as soon as
// the row's timings allow; PREA and REF are for all banks.
enum class DramOperation : std::uint8_t { ACT, RD, WR, RDA, WRA, PRE, PREA, REF };
inline constexpr std::array<std::string_view, 8> DramOperationNames{
    "ACT", "RD", "WR", "RDA", "WRA", "PRE", "PREA", "REF"};

struct IssuedCommand {
    MemoryCycle at = 0; // of the memory's clock
    std::uint32_t channel = 0, bank = 0;
    DramOperation operation = DramOperation::ACT;
    std::uint64_t row = 0; // ACT, RD, WR, RDA, WRA
    // Of a request's columns, one for each burst of its data, MemoryConfig::column_spacing() apart:
    // how many, and the first byte's place in the row. The last of them closes the row.
    std::uint32_t bursts = 1, byte = 0;
};

// Is told of each command when it goes out; of a request's columns with the first. Other banks'
// commands go out between these.
class DramCommandObserver {
public:
    virtual ~DramCommandObserver() = default;
    virtual void issued(const IssuedCommand& command) = 0;
};

} // namespace ffgpu::timing
