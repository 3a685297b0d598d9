// How a tile-based machine bins primitives, what it writes down of them, and how it knows what of a
// bin it need not load.

#pragma once

#include "model/base/parameters.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::work {

enum class Binning : std::uint8_t { Exact, BoundingBox };
inline constexpr std::array<std::string_view, 2> BinningNames{"exact", "bounding_box"};

struct TileOrder {
    Binning binning = Binning::Exact;
    std::uint32_t header_bytes = 16;
    std::uint32_t record_bytes = 96;
    std::uint32_t entry_bytes = 4;
    std::uint32_t parameter_buffer_bytes = 1 << 20;
    bool detects_overwrite = true;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("binning",
              self.binning,
              {.meaning = "bins whose lists a primitive is put in: those where it covers a sample, "
                          "or all that the bounding box of its corners on the screen touches",
               .choices = BinningNames});
        field("header_bytes",
              self.header_bytes,
              {.unit = "bytes",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "in the parameter buffer, of a bin that is drawn"});
        field("record_bytes",
              self.record_bytes,
              {.unit = "bytes",
               .minimum = 1,
               .maximum = 4096,
               .meaning = "of a primitive that is set up, written once"});
        field("entry_bytes",
              self.entry_bytes,
              {.unit = "bytes",
               .minimum = 1,
               .maximum = 256,
               .meaning = "of a primitive in a bin's list"});
        field("parameter_buffer_bytes",
              self.parameter_buffer_bytes,
              {.unit = "bytes",
               .minimum = 64,
               .maximum = 1 << 30,
               .meaning = "of one parameter buffer; a scene that needs more is cut and drawn in "
                          "parts"});
        field("detects_overwrite",
              self.detects_overwrite,
              {.meaning = "a bin's colour that is written to the last sample before it is read is "
                          "not loaded; false: only clears are known to overwrite"});
    }
};

} // namespace ffgpu::work
