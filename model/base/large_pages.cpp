#include "model/base/large_pages.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace ffgpu {
namespace {

// The heap of a thread: in glibc a block of this size at a multiple of it (malloc/arena.c,
// HEAP_MAX_SIZE).
constexpr std::size_t ThreadHeap = std::size_t{64} << 20;
constexpr std::size_t LargePage = std::size_t{2} << 20;
constexpr std::size_t FirstHeap = std::size_t{256} << 20; // of addresses: what is touched counts
constexpr std::size_t UsualStep = std::size_t{128} << 10; // of glibc

std::atomic<bool> takes_heaps{false};

void advise(std::uintptr_t begin, std::uintptr_t end) {
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    begin = begin / page * page;
    // A host that has none of them refuses.
    if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

bool has_limit() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY ||
           ::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

std::uintptr_t heap_end() {
    return reinterpret_cast<std::uintptr_t>(::sbrk(0));
}

class HeapBlock {
public:
    explicit HeapBlock(std::size_t bytes)
        : block_(std::malloc(bytes)) {}
    ~HeapBlock() { std::free(block_); }
    HeapBlock(const HeapBlock&) = delete;
    HeapBlock& operator=(const HeapBlock&) = delete;

    std::uintptr_t place() const { return reinterpret_cast<std::uintptr_t>(block_); } // 0: none

private:
    void* volatile block_; // A compiler may leave out a block that nobody reads.
};

// No large page comes where a small one was touched: what is left of the first is kept back.
std::size_t rest_of_large_page(std::uintptr_t place) {
    return LargePage - place % LargePage;
}

} // namespace

void advise_large_pages(std::span<std::byte> bytes) {
    const auto begin = reinterpret_cast<std::uintptr_t>(bytes.data());
    advise(begin, begin + bytes.size());
}

void take_heap_in_large_pages() {
    if (has_limit()) return;
    const std::uintptr_t begin = heap_end();
    ::mallopt(M_TOP_PAD, FirstHeap); // The heap grows by this, beyond what it is asked for.
    static const HeapBlock kept_back(rest_of_large_page(begin) + UsualStep);
    const bool grows = kept_back.place() != 0 && heap_end() > begin;
    ::mallopt(M_TOP_PAD, grows ? ThreadHeap : UsualStep);
    if (!grows) return;
    advise(begin, heap_end());
    takes_heaps = true;
}

void take_thread_heap_in_large_pages() {
    if (!takes_heaps) return;
    const std::uintptr_t begin = HeapBlock(1).place() / ThreadHeap * ThreadHeap;
    advise(begin, begin + ThreadHeap);
    thread_local const HeapBlock kept_back(LargePage);
}

} // namespace ffgpu
