// Container: the outer shell of a trace file, which compresses one stream of bytes. apitrace writes
// Snappy blocks; gzip and Zstandard come from its older and newer versions.

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::trace {

class InputFile;

// Memory is bounded by what the file holds: a length that the file claims is never believed before
// that many bytes have been seen.
class Container {
public:
    virtual ~Container() = default;

    // Replaces `chunk` by the next piece of the uncompressed stream, about 1 MiB; false at the end.
    // Bytes before a damaged place are still delivered; the call after them throws Damage.
    virtual bool next(std::vector<std::byte>& chunk) = 0;

    // Back to the first piece.
    virtual void rewind() = 0;
};

// Tells the kind of container by its first bytes. Throws InputError.
std::unique_ptr<Container> open_container(const std::string& path);

std::unique_ptr<Container> open_snappy(std::unique_ptr<InputFile> file);
std::unique_ptr<Container> open_gzip(std::unique_ptr<InputFile> file);
std::unique_ptr<Container> open_zstd(std::unique_ptr<InputFile> file);

} // namespace ffgpu::trace
