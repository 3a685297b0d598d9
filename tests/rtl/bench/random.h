// Seeded numbers, the same everywhere, and coverage bins.

#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ffgpu::rtl {

class Random { // splitmix64
public:
    explicit Random(std::uint64_t seed)
        : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    }
    std::uint32_t word() { return static_cast<std::uint32_t>(bits() >> 32); }
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>((bits() >> 32) * count >> 32);
    }
    bool one_in(std::uint32_t count) { return below(count) == 0; }

    // Values at the ends and around the middle come often.
    std::uint8_t byte() {
        static constexpr std::array<std::uint8_t, 6> Edges{0, 1, 127, 128, 254, 255};
        return one_in(4) ? Edges[below(6)] : static_cast<std::uint8_t>(word());
    }
    template <class Enum>
    Enum any(unsigned count) {
        return static_cast<Enum>(below(count));
    }

private:
    std::uint64_t state_;
};

// Cases that a run has to have met, declared beforehand: bin `index` of `count` under a name.
class Bins {
public:
    void declare(const std::string& name, std::size_t count) { bins_[name].resize(count); }
    void hit(const std::string& name, std::size_t index) { ++bins_.at(name).at(index); }
    std::string empty() const {
        std::string text;
        for (const auto& [name, counts] : bins_)
            for (std::size_t i = 0; i < counts.size(); ++i)
                if (counts[i] == 0) text += name + '[' + std::to_string(i) + "] ";
        return text;
    }

private:
    std::map<std::string, std::vector<std::uint64_t>> bins_;
};

} // namespace ffgpu::rtl
