// When the sender has something to offer and the receiver takes it.

#pragma once

#include "tests/rtl/bench/random.h"

#include <array>

namespace ffgpu::rtl {

enum class Stall : std::uint8_t { Never, Sender, Receiver, Bursts };

constexpr std::array AllStalls{Stall::Never, Stall::Sender, Stall::Receiver, Stall::Bursts};

class Stalls {
public:
    Stalls(Stall kind, Random& random)
        : kind_(kind)
        , random_(random) {}

    bool offers() {
        if (kind_ == Stall::Bursts) return sender_.next(random_);
        return kind_ != Stall::Sender || random_.one_in(3);
    }
    bool takes() {
        if (kind_ == Stall::Bursts) return receiver_.next(random_);
        return kind_ != Stall::Receiver || random_.one_in(3);
    }

private:
    // Runs of cycles on and off.
    struct Burst {
        bool on = true;
        unsigned left = 0;

        bool next(Random& random) {
            if (left-- == 0) {
                on = !on;
                left = random.below(on ? 40 : 20);
            }
            return on;
        }
    };

    Stall kind_;
    Random& random_;
    Burst sender_, receiver_;
};

} // namespace ffgpu::rtl
