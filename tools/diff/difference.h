// Where two backends part: the first command whose accounts differ, and in it the first entry and
// field, in the order in which the machine works.

#pragma once

#include "tools/diff/account_stream.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::tools {

// One line of each side that is not the other's.
struct DifferentEntry {
    std::string part, place;
    std::string field, a, b; // the first that differs; "", and what stands there: only one has it
};

struct Difference {
    // As the account's lines name the command.
    std::uint64_t command = 0;
    std::string frame{}, draw{}, call{}, call_name{}, name{};
    std::vector<std::string> parts{}; // that differ, in the machine's order
    std::vector<DifferentEntry> entries{};
};

struct DiffOptions {
    AccountSide a, b;
    AccountQuestion question; // with a command: its entries alone
    std::size_t most_entries = 1;
};

// Nothing: the accounts are equal. Throws InputError.
std::optional<Difference> find_difference(const DiffOptions& options);

} // namespace ffgpu::tools
