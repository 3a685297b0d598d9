#include "model/memory/device_memory.h"

#include "model/base/check.h"
#include "model/base/large_pages.h"

#include <new>

#include <sys/mman.h>

namespace ffgpu {

DeviceMemory::DeviceMemory(std::uint64_t bytes) {
    check(bytes > 0 && bytes <= std::uint64_t{1} << 32, "device memory is 1 byte to 4 GiB");
    void* const range = mmap(nullptr,
                             bytes + SlackBytes,
                             PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                             -1,
                             0);
    if (range == MAP_FAILED) throw std::bad_alloc();
    bytes_ = {static_cast<std::byte*>(range), bytes};
    advise_large_pages(bytes_);
}

DeviceMemory::~DeviceMemory() {
    munmap(bytes_.data(), bytes_.size() + SlackBytes);
}

void DeviceMemory::clear() {
    check(madvise(bytes_.data(), bytes_.size() + SlackBytes, MADV_DONTNEED) == 0,
          "the host takes back the device's memory");
}

} // namespace ffgpu
