// PipeCycles: a file with a line a draw: the cycles that the Verilated pipe took from its first
// record's being taken to its last store, and what each of its units was at.

#pragma once

#include "model/base/whole_file.h"
#include "rtl/pipe/pipe.h"

#include <cstdint>
#include <string>
#include <utility>

namespace ffgpu::tools {

class PipeCycles {
public:
    // Throws InputError where the file cannot be written, as write() and commit().
    explicit PipeCycles(const std::string& path);

    void begin_draw() { begin_ = None; }
    void added(const rtl::Pipe& pipe); // a record of the draw
    void end_draw(const rtl::Pipe& pipe, std::uint32_t draw);
    // The lines of the draws that have ended.
    void write() { file_.write(std::exchange(lines_, {})); }
    void commit();

private:
    static constexpr std::uint64_t None = ~std::uint64_t{0};

    WholeFile file_;
    std::string lines_;          // that are not written yet
    std::uint64_t begin_ = None; // No record was taken.
    rtl::PipeActivity before_;   // when the draw before had ended
};

} // namespace ffgpu::tools
