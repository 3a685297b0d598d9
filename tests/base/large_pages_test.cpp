// Large pages, by what the system tells of the process' memory.

#include "model/base/large_pages.h"
#include "model/base/thread_without_signals.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>

#include <catch2/catch.hpp>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ffgpu {
namespace {

constexpr std::size_t Bytes = std::size_t{8} << 20;

bool host_has_large_pages() {
    return std::filesystem::exists("/sys/kernel/mm/transparent_hugepage");
}

// Whether the mapping that holds the address is one for which they were advised ("hg").
bool is_advised(const void* address) {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    std::ifstream maps("/proc/self/smaps");
    bool holds = false;
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2)
            holds = begin <= at && at < end;
        if (holds && line.starts_with("VmFlags:")) return line.find(" hg") != std::string::npos;
    }
    return false;
}

bool is_advised_block() {
    const std::unique_ptr<void, void (*)(void*)> block(std::malloc(Bytes), std::free);
    return block != nullptr && is_advised(block.get());
}

// In a process of its own, whose heap is as main's: its exit status.
template <class Run>
int in_process(Run&& run) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(run());
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// Blocks of some megabytes come from the heap, as the program asks for it.
void take_heap() {
    ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
    take_heap_in_large_pages();
}

bool has_own_heap() { // A sanitizer's is not glibc's.
    return ::mallinfo2().arena > 0;
}

TEST_CASE("large pages are advised of a mapping") {
    if (!host_has_large_pages()) return;
    void* const at =
        ::mmap(nullptr, Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(at != MAP_FAILED);
    CHECK_FALSE(is_advised(at));
    advise_large_pages({static_cast<std::byte*>(at), Bytes});
    CHECK(is_advised(at));
    ::munmap(at, Bytes);
}

TEST_CASE("the heaps of the process and of its threads are taken in large pages, once asked for") {
    if (!host_has_large_pages() || !has_own_heap()) return;
    CHECK(in_process([] { return is_advised_block() ? 1 : 0; }) == 0);
    CHECK(in_process([] {
              take_heap();
              return is_advised_block() ? 0 : 1;
          }) == 0);
    CHECK(in_process([] {
              take_heap();
              bool advised = false;
              thread_without_signals([&] { advised = is_advised_block(); }).join();
              return advised ? 0 : 1;
          }) == 0);
    CHECK(in_process([] {
              bool advised = true;
              thread_without_signals([&] { advised = is_advised_block(); }).join();
              return advised ? 1 : 0;
          }) == 0);
}

TEST_CASE("a limited address space is left as it is") {
    if (!has_own_heap()) return;
    CHECK(in_process([] {
              const rlimit limit{std::size_t{8} << 30, RLIM_INFINITY};
              if (::setrlimit(RLIMIT_AS, &limit) != 0) return 1;
              const auto* const before = static_cast<const char*>(::sbrk(0));
              take_heap_in_large_pages();
              return static_cast<const char*>(::sbrk(0)) - before < (1 << 20) ? 0 : 2;
          }) == 0);
}

} // namespace
} // namespace ffgpu
