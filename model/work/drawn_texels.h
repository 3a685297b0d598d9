// DrawnTexels: the pixels of textures that commands wrote as their targets, kept until a draw reads
// one of these textures. What a state's masks, tests and scissor let through no pixel of is not
// among them.

#pragma once

#include "model/work/address_map.h"
#include "model/work/whole_command.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ffgpu::work {

class DrawnTexels {
public:
    explicit DrawnTexels(AddressMap& addresses)
        : addresses_(addresses) {}

    // Where the draw reads a texture that was drawn into before: the lines of all that was drawn,
    // as AddressMap::memory_written() returns them.
    std::vector<std::uint64_t> take(const Registers& draw);

    void clear(const WorkDraw& clear);
    // A draw or an image, behind take(); then all its quads, in any order.
    void begin(const WorkDraw& draw);
    void add(std::span<const WorkQuad> quads);

private:
    struct Drawn {
        Surface target;
        std::vector<bool> pixels; // of all samples alike; row by row

        ByteRange bytes() const { return {target.address, target.address + target.bytes()}; }
        void mark(int x0, int x1, int y);
    };
    // The current draw's target among drawn_, and which of its fragments write it.
    struct Marked {
        std::size_t drawn = 0;
        bool failed = false; // those that a test ended, too
    };

    // Among drawn_; nothing where no texture lies there.
    std::optional<std::size_t> find(const Surface& target);

    AddressMap& addresses_;
    std::vector<Drawn> drawn_;
    std::vector<Marked> marked_;
};

} // namespace ffgpu::work
