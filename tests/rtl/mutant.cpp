// The number of the mutant that runs; 0: none. Read by expressions that tests/rtl/mutants.py wrote
// into the RTL.

#include <cstdlib>

namespace {

int chosen() {
    const char* const number = std::getenv("FFGPU_RTL_MUTANT");
    return number ? std::atoi(number) : 0;
}

} // namespace

int ffgpu_rtl_mutant = chosen();
