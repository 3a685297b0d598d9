// PipeCycles: a file with a line a draw: the cycles that the Verilated pipe took from its first
// record's being taken to its last store, and what each of its units was at.

#pragma once

#include "rtl/pipe/pipe.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace ffgpu::tools {

class PipeCycles {
public:
    // Throws InputError.
    explicit PipeCycles(const std::string& path);

    void begin_draw() { begin_ = None; }
    void added(const rtl::Pipe& pipe); // a record of the draw
    void end_draw(const rtl::Pipe& pipe, std::uint32_t draw);

private:
    static constexpr std::uint64_t None = ~std::uint64_t{0};

    std::ofstream out_;
    std::uint64_t begin_ = None; // No record was taken.
    rtl::PipeActivity before_;   // when the draw before had ended
};

} // namespace ffgpu::tools
