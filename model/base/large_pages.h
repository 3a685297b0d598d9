// Memory in large pages of the host (Linux' transparent huge pages, on advice): what is touched for
// the first time comes 2 MiB at a time, not 4 KiB, and the processor finds its addresses sooner.
// What a short run does it does mostly in new memory (docs/performance.md). Where the host has no
// such pages nothing changes; nothing but time ever depends on them.

#pragma once

#include <cstddef>
#include <span>

namespace ffgpu {

// Of a mapping of its own. What lies beside the bytes in their first and last page is meant, too.
void advise_large_pages(std::span<std::byte> bytes);

// The process' heap, and from now on those of threads that call the other one. By main, before
// there are threads. Not where the address space is limited: it grows by large steps.
void take_heap_in_large_pages();
// By a thread, first.
void take_thread_heap_in_large_pages();

} // namespace ffgpu
