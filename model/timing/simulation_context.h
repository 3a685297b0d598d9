// SimulationContext: a SystemC kernel of one's own. SystemC keeps one kernel in a global; switching
// that global is how several simulations live in a process, one running at a time.

#pragma once

#include <mutex>
#include <systemc>

namespace ffgpu::timing {

class SimulationContext {
public:
    SimulationContext()
        : context_(new sc_core::sc_simcontext) {}
    ~SimulationContext() { delete context_; }
    SimulationContext(const SimulationContext&) = delete;
    SimulationContext& operator=(const SimulationContext&) = delete;

    // Makes the context the global one while it lives; waits for scopes of other threads.
    class Scope {
    public:
        explicit Scope(const SimulationContext& context)
            : one_at_a_time_(mutex())
            , before_(sc_core::sc_curr_simcontext) {
            sc_core::sc_curr_simcontext = context.context_;
        }
        ~Scope() { sc_core::sc_curr_simcontext = before_; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        static std::recursive_mutex& mutex() {
            static std::recursive_mutex one;
            return one;
        }

        const std::lock_guard<std::recursive_mutex> one_at_a_time_;
        sc_core::sc_simcontext* before_;
    };

private:
    sc_core::sc_simcontext* context_;
};

} // namespace ffgpu::timing
