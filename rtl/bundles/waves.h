// Waves of a Verilated module, for GTKWave: every signal under its place in the hierarchy, a packed
// structure as a scope with its fields.
//
// One sample when a cycle's inputs have settled (the clock is low) and one after its edge: cycle n
// of the module begins at time 2 n. A module can only be watched where it was Verilated for it
// (FFGPU_RTL_WAVES): watched modules are slower, also where nothing is written.

#pragma once

#include "rtl/bundles/wave_cycles.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <verilated.h>

#if VM_TRACE_FST
#include <verilated_fst_c.h>
#endif

namespace ffgpu::rtl {

#if VM_TRACE_FST
inline constexpr bool CanWriteWaves = true;
#else
inline constexpr bool CanWriteWaves = false;
#endif
inline constexpr const char* NoWaves =
    "--fst: the units in RTL were Verilated without waves (cmake -D FFGPU_RTL_WAVES=ON)";

class Waves {
public:
    // Of nothing.
    Waves() = default;
    // Into FOLDER/NAME.fst, from now on; of nothing where there is no folder. `dut` outlives it.
    template <class Dut>
    Waves([[maybe_unused]] Dut& dut,
          [[maybe_unused]] const std::filesystem::path& folder,
          [[maybe_unused]] const std::string& name,
          const WaveCycles& cycles = {})
        : cycles_(cycles) {
#if VM_TRACE_FST
        if (folder.empty()) return;
        std::filesystem::create_directories(folder);
        dut.contextp()->traceEverOn(true);
        file_ = std::make_unique<VerilatedFstC>();
        dut.trace(file_.get(), MostLevels);
        file_->open((folder / (name + ".fst")).c_str());
#endif
    }

    // The module as it stands with the inputs of a cycle, and after the edge that ends it.
    void settled() {
        write(2 * cycle_);
    }
    void clocked() {
        write(2 * cycle_++ + 1);
    }

private:
    void write([[maybe_unused]] std::uint64_t time) {
#if VM_TRACE_FST
        if (file_ && cycles_.has(time / 2)) file_->dump(time);
#endif
    }

    static constexpr int MostLevels = 99; // of the hierarchy: all

#if VM_TRACE_FST
    std::unique_ptr<VerilatedFstC> file_;
#endif
    WaveCycles cycles_;
    std::uint64_t cycle_ = 0;
};

} // namespace ffgpu::rtl
