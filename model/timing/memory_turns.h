// MemoryTurns: the requests that a channel of the memory served last. Clients come to a channel in
// an order that hangs on the resources that there are: a request that without one of them would
// come before another's does not stand behind that then, but goes before it.

#pragma once

#include "model/timing/moment.h"

#include <array>
#include <cstddef>
#include <span>

namespace ffgpu::timing {

// A request that was answered.
struct AnsweredRequest {
    Cycle asked = 0, answered = 0;
    Saved asked_saved{}, answer_saved{}; // how much sooner they would have been
    Saved idle{}; // without each resource: cycles that the channel would have stood before it
};

// One that is answered now, and those before it.
struct RequestInTurn {
    struct Before {
        AnsweredRequest* answered = nullptr;
        float later = 0;  // cycles that the answer waited beyond its turn behind this one
        float sooner = 0; // and that it would have to come sooner to go before it
        bool came_later = false;
    };
    const Saved& asked;
    const Saved& alone; // how much sooner it would be answered if it stood behind nobody
    float takes = 0;    // cycles, all of the bandwidth, behind the answer before it
    std::span<const Before> before; // the oldest first, but those that came later behind all others
    bool has_rare = true; // false: in the rare lanes nothing is saved, which nobody has to find out
};
// More than any saves: it stands behind nobody.
inline constexpr float NoTurn = 1e9F;
struct SavedInTurn {
    Saved answer{}, idle{};
};
// What one overtakes waits for it, as long as the channel would not have stood before. By vectors;
// the plain form is what it must equal.
SavedInTurn saved_in_turn(const RequestInTurn& request);
SavedInTurn saved_in_turn_plainly(const RequestInTurn& request);

class MemoryTurns {
public:
    // The answer in this cycle, which depends on its request and on the answer before it: how much
    // sooner it would have been without each resource.
    Saved answer(const Dependence& own, const Dependence& turn, Cycle now, bool has_rare = true);
    // To a request that nobody of the pipe sent.
    void note_answer(Cycle asked, const Saved& saved, Cycle now);

private:
    static constexpr std::size_t Kept = 16;

    AnsweredRequest& next() { return served_[next_++ % Kept]; }

    std::array<AnsweredRequest, Kept> served_{};
    std::size_t next_ = 0;
};

} // namespace ffgpu::timing
