// The memory behind the pipe's ports: answers after a latency, and stalls at random.

#pragma once

#include "rtl/pipe/pipe.h"

#include <array>
#include <cstring>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace ffgpu::rtl {

// A small generator, so that a seed gives the same run everywhere.
class Stalls {
public:
    explicit Stalls(const PipeOptions& options)
        : state_(options.seed * 0x9e3779b97f4a7c15 | 1)
        , percent_(options.stall_percent) {}

    bool next() { return percent_ != 0 && below(100) < percent_; }
    unsigned below(unsigned limit) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<unsigned>(state_ >> 33) % limit;
    }

private:
    std::uint64_t state_;
    unsigned percent_;
};

// Bytes that are not there read as 0, and are not written: a faulty pipe may ask for any.
class PipeMemory {
public:
    void set(std::span<std::byte> memory) { memory_ = memory; }

    void read(std::uint32_t at, void* to, std::size_t bytes) const {
        std::memset(to, 0, bytes);
        if (at < memory_.size())
            std::memcpy(to, memory_.data() + at, std::min(bytes, memory_.size() - at));
    }
    void write(std::uint32_t at, std::uint64_t data, unsigned enables) const {
        for (unsigned byte = 0; byte < 8; ++byte)
            if ((enables >> byte & 1) != 0 && at + byte < memory_.size())
                memory_[at + byte] = static_cast<std::byte>(data >> 8 * byte);
    }

private:
    std::span<std::byte> memory_;
};

// Lines of texels, in any order.
class TexelPort {
public:
    using Line = std::array<std::uint32_t, 16>;
    struct Answer {
        std::uint64_t due;
        unsigned fill;
        std::uint32_t address;
    };

    void ask(std::uint64_t due, unsigned fill, std::uint32_t address) {
        asked_.push_back({due, fill, address});
    }
    // One of those that are due; the oldest, or any.
    std::optional<Answer> take(std::uint64_t cycle, Stalls& stalls, bool in_order) {
        if (asked_.empty() || stalls.next()) return std::nullopt;
        const std::size_t i =
            in_order || asked_.size() == 1 ? 0 : stalls.below(static_cast<unsigned>(asked_.size()));
        if (asked_[i].due > cycle) return std::nullopt;
        const Answer answer = asked_[i];
        if (!in_order) std::swap(asked_[i], asked_.back());
        asked_.erase(in_order ? asked_.begin() : asked_.end() - 1);
        return answer;
    }

private:
    std::vector<Answer> asked_;
};

// Words of a target, in the order of the requests. What a read gives is what stood there when it
// was asked: a store that comes later is not seen.
class TargetPort {
public:
    using Words = std::array<std::uint32_t, 4>;

    void ask(std::uint64_t due, const Words& words) { asked_.push_back({due, words}); }
    const Words* offered(std::uint64_t cycle) const {
        return asked_.empty() || asked_.front().due > cycle ? nullptr : &asked_.front().words;
    }
    void taken() { asked_.pop_front(); }

private:
    struct Answer {
        std::uint64_t due;
        Words words;
    };
    std::deque<Answer> asked_;
};

} // namespace ffgpu::rtl
