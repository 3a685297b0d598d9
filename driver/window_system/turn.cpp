#include "driver/window_system/turn.h"

#include "driver/context/context.h"
#include "driver/context/current.h"

#include <cstdlib>
#include <mutex>
#include <thread>

#include <linux/membarrier.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace ffgpu::gl {

namespace {

std::recursive_mutex mutex;
bool has_owner = false;          // The bias was given to some thread. Guarded by the mutex.
Context* registers_of = nullptr; // whose registers the device holds, among threads that share

long membarrier(int command) {
    return ::syscall(SYS_membarrier, command, 0, 0);
}

bool can_revoke() {
    return membarrier(MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED) == 0;
}

// In the mutex.
void revoke_bias() {
    if (detail::turn_state.shared.load(std::memory_order_relaxed)) return;
    detail::turn_state.shared.store(true, std::memory_order_seq_cst);
    if (!has_owner) return;
    if (membarrier(MEMBARRIER_CMD_PRIVATE_EXPEDITED) != 0) std::abort(); // It was registered.
    while (detail::turn_state.inside.load(std::memory_order_acquire) != 0)
        std::this_thread::yield();
}

// Another context's registers may be in the device. (One made current anew sends its own anyway,
// so that a destroyed context's address may come again.)
void enter_context() {
    Context* const context = current_context();
    if (!context || context == registers_of) return;
    context->registers.forget();
    registers_of = context;
}

} // namespace

namespace detail {

TurnState turn_state;
constinit thread_local bool owns_turn = false;

bool lock_turn() {
    mutex.lock();
    if (!has_owner && !turn_state.shared.load(std::memory_order_relaxed) && can_revoke()) {
        has_owner = owns_turn = true;
        turn_state.inside.store(1, std::memory_order_relaxed);
        mutex.unlock();
        return true;
    }
    owns_turn = false;
    revoke_bias();
    enter_context();
    return false;
}

void unlock_turn() {
    mutex.unlock();
}

} // namespace detail

} // namespace ffgpu::gl
