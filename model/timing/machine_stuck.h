// MachineStuck: the machine in time goes on no more. Its wiring is wrong, or a memory of the user's
// does not answer. The text is a report of many lines (stuck_report.h).

#pragma once

#include <stdexcept>

namespace ffgpu::timing {

class MachineStuck : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The status that a program ends with.
inline constexpr int StuckStatus = 3;

} // namespace ffgpu::timing
