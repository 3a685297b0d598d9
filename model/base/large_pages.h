// Memory in large pages of the host (Linux' transparent huge pages), where it gives them on advice:
// what is touched for the first time comes 2 MiB at a time, and the processor's table of pages
// reaches further. By the clock a fifth to a half of what works in new memory, as batches of quads
// are. Nothing else depends on it: where there is no such page, there are small ones.

#pragma once

#include <cstddef>
#include <span>

namespace ffgpu {

// Of a mapping of its own. What lies beside the bytes in their first and last page is meant, too.
void advise_large_pages(std::span<std::byte> bytes);

// The process' heap, and from now on those of threads that call the other one. By main, before
// there are threads. Not where the address space is limited: growing by large steps takes of it.
void take_heap_in_large_pages();
// By a thread, first.
void take_thread_heap_in_large_pages();

} // namespace ffgpu
