// DepthTiming: depth and stencil tests in time, before texturing where the draw allows it and after
// the fragment stages where not. One unit, one cache, two paths; the late path goes first. Quads of
// the other kind pass through.
//
// Where coarse depths are kept, every quad that comes in is tested against them first. Where values
// are followed, a quad that is tested early waits for those at its place that are on their way to
// the late test.

#pragma once

#include "model/timing/block_states.h"
#include "model/timing/channel.h"
#include "model/timing/hierarchical_depth.h"
#include "model/timing/in_flight.h"
#include "model/timing/parked_quads.h"
#include "model/timing/pending_writes.h"
#include "model/timing/quad_observer.h"
#include "model/timing/target_interlock.h"
#include "model/timing/unit.h"

#include <functional>

namespace ffgpu::timing {

class DepthTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& early_in;
        Channel<QuadToken>& early_out;
        Channel<QuadToken>& late_in;
        Channel<QuadToken>& late_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
        BlockStates* blocks;       // null: values are not followed
        HierarchicalDepth* coarse; // null: none is kept
    };

    // `on_late_end` sees each quad of which the late tests leave no fragment, and the cycle.
    DepthTiming(sc_core::sc_module_name name,
                const Clock& clock,
                const TimingConfig& config,
                const Ports& ports,
                InFlight& in_flight,
                std::function<void(const QuadToken&, Cycle)> on_late_end);

    std::string state() const override;

    void set_observer(QuadObserver* observer) { observer_ = observer; } // or null
    // The quads that wait for their depths.
    const ParkedQuads& early() const { return early_; }
    const ParkedQuads& late() const { return late_; }

private:
    enum class Path { Early, Late };
    // What is left in a cycle.
    struct Budget {
        std::uint32_t lookups = 0, tests = 0;
        std::uint32_t culled = 0; // by those tests, so far
    };
    // Of the quad at the front of the early path.
    enum class Coarse { Untested, Undecided, Accepted };

    Activity step() override;
    // What a path takes in a cycle is compiled for each of the two. True: it did something.
    template <Path path>
    bool work(Budget& budget, Activity& reason);
    template <Path path>
    bool look_up(Budget& budget, Activity& reason); // of the quad that is there
    bool look_up_lines(Path path, const QuadToken& token, Budget& budget, Activity& reason);
    LineMask bytes_read(const QuadToken& token, std::size_t line) const;
    LineAccess access(Path path, const QuadToken& token, std::size_t line) const;
    work::WrittenBytes written_bytes(Path path, const QuadToken& token, std::size_t line) const;
    // False: it is culled, or has to wait for a cycle with tests left.
    bool test_coarse(const QuadToken& token, Budget& budget, bool& culled);
    void cull(const QuadToken& token);
    bool waits_for_others(const QuadToken& token) const;
    void announce(const QuadToken& token);
    void complete(const QuadToken& token);
    bool tests_here(Path path, const PreparedDraw& draw) const;
    bool writes_late(const PreparedDraw& draw) const;
    template <Path path>
    bool send(Activity& reason); // the oldest of those parked
    bool read_pixels(Budget& budget, Activity& reason);
    void store_pixels(const QuadToken& token);
    bool end_dead(const QuadToken& token);
    Cycle next_work(Activity last) const override;
    bool is_past_cache(Path path) const { return path == Path::Late && !ports_.cache.is_enabled(); }

    const TimingConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    const bool orders_writes_; // early tests after late ones of the same place
    ParkedQuads early_, late_;
    LineWalk early_walk_, late_walk_; // of the quads that are looked up
    Coarse coarse_ = Coarse::Untested;
    PendingWrites pending_;     // by place
    TargetInterlock interlock_; // without a cache
    QuadObserver* observer_ = nullptr;
    std::function<void(const QuadToken&, Cycle)> on_late_end_;
};

} // namespace ffgpu::timing
