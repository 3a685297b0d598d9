// LineNumbers: numbers lines from 0 on, densely where they lie together.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

class LineNumbers {
public:
    LineNumbers()
        : slots_(FirstSlots) {}

    // The line's number, which is the same ever after; lines before may have gaps behind them.
    std::uint32_t operator[](std::uint64_t line) {
        const std::uint64_t page = line / PageLines;
        Slot& recent = recent_[page % recent_.size()];
        if (recent.page != page) recent = find(page);
        return recent.first + static_cast<std::uint32_t>(line % PageLines);
    }

    // All numbers so far are less.
    std::uint32_t end() const { return end_; }

private:
    static constexpr std::uint64_t NoPage = ~std::uint64_t{0};
    static constexpr std::uint64_t PageLines = 16;
    static constexpr std::size_t FirstSlots = 256; // a power of two

    struct Slot {
        std::uint64_t page = NoPage;
        std::uint32_t first = 0; // number of its first line
    };

    std::size_t place_of(std::uint64_t page) const;
    const Slot& find(std::uint64_t page);
    void grow();

    std::vector<Slot> slots_; // open addressing
    std::size_t used_ = 0;
    std::uint32_t end_ = 0;
    std::array<Slot, 64> recent_{};
};

} // namespace ffgpu::work
