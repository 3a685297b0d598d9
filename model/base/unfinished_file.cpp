#include "model/base/unfinished_file.h"

#include <atomic>
#include <climits>
#include <cstring>

#include <sys/types.h>
#include <unistd.h>

namespace ffgpu {
namespace {

constexpr pid_t Free = 0;
constexpr pid_t Taken = -1; // by a thread that writes or removes it

} // namespace

// A handler must not wait for a lock, nor read a name that another thread changes or frees: a place
// is whose number stands in `owner`, and who takes it away has it alone.
struct UnfinishedFile::Place {
    std::atomic<pid_t> owner{Free}; // the process whose file it is
    char name[PATH_MAX];

    bool take_from(pid_t from) noexcept { return owner.compare_exchange_strong(from, Taken); }
};

static_assert(std::atomic<pid_t>::is_always_lock_free);

UnfinishedFile::Place UnfinishedFile::places_[64];

UnfinishedFile::UnfinishedFile(const std::string& path) noexcept {
    if (path.size() >= sizeof Place::name) return;
    for (Place& place : places_) {
        if (!place.take_from(Free)) continue;
        std::memcpy(place.name, path.c_str(), path.size() + 1);
        place.owner = ::getpid();
        place_ = &place;
        return;
    }
}

UnfinishedFile::~UnfinishedFile() {
    if (!place_) return;
    // One that a handler has taken stays taken. A forked child's is a copy, of its parent's number.
    pid_t owner = place_->owner;
    if (owner != Taken) place_->owner.compare_exchange_strong(owner, Free);
}

void UnfinishedFile::remove_all() noexcept {
    const pid_t own = ::getpid();
    for (Place& place : places_)
        if (place.take_from(own)) ::unlink(place.name);
}

} // namespace ffgpu
