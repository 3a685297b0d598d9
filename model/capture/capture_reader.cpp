#include "model/capture/capture_reader.h"

#include "model/base/input_error.h"
#include "model/capture/capture_format.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <zstd.h>

namespace ffgpu::capture {

bool CaptureReader::is_capture(const std::string& path) {
    const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
    std::array<char, Magic.size()> magic{};
    return file && std::fread(magic.data(), 1, magic.size(), file.get()) == magic.size() &&
           magic == Magic;
}

CaptureReader::CaptureReader(std::string path)
    : path_(std::move(path))
    , file_(std::fopen(path_.c_str(), "rb")) {
    if (!file_) throw InputError(path_ + ": cannot be opened: " + std::strerror(errno));
    read_header();
}

void CaptureReader::rewind() {
    std::rewind(file_.get());
    file_position_ = 0;
    chunk_.clear();
    at_ = 0;
    read_header();
}

void CaptureReader::read_header() {
    std::array<std::byte, HeaderBytes> bytes{};
    if (read_file(bytes) < bytes.size() ||
        std::memcmp(bytes.data(), Magic.data(), Magic.size()) != 0)
        throw InputError(path_ + ": byte 0: not a capture: expected 'ffgpucap' and a header");
    Header header;
    std::memcpy(&header.version, bytes.data() + 8, 4);
    std::memcpy(&header.register_map, bytes.data() + 12, 4);
    std::memcpy(&header.memory_bytes, bytes.data() + 16, 8);
    std::memcpy(&header.first_frame, bytes.data() + 24, 4);
    if (header.version != Version)
        throw InputError(path_ + ": capture version " + std::to_string(header.version) +
                         "; version " + std::to_string(Version) + " can be read");
    if (header.register_map != register_map_fingerprint())
        throw InputError(path_ + ": made by another release: its device has other registers");
    constexpr std::uint64_t Most = std::uint64_t{1} << 32;
    if (header.memory_bytes > Most)
        throw InputError(path_ + ": byte 16: expected a memory of at most " + std::to_string(Most) +
                         " bytes, found " + std::to_string(header.memory_bytes));
    memory_size_ = header.memory_bytes;
    first_frame_ = header.first_frame;
    check_ = CommandCheck(memory_size_);
}

std::optional<ShownPicture> CaptureReader::play_frame(Device& device) {
    for (;;) {
        if (at_ == chunk_.size() && !next_chunk()) return std::nullopt;
        switch (const auto kind = static_cast<Record>(take(1)[0])) {
        case Record::WriteMemory:
            play_write(device);
            break;
        case Record::ReadMemory:
            play_read(device);
            break;
        case Record::Submit:
            play_commands(device);
            break;
        case Record::Finish:
            device.finish();
            break;
        case Record::Shown:
            return take_shown();
        default:
            damaged("expected a record's kind (1 to 5), found " +
                    std::to_string(static_cast<unsigned>(kind)));
        }
    }
}

// False at the end mark.
bool CaptureReader::next_chunk() {
    chunk_position_ = file_position_;
    chunk_.clear();
    at_ = 0;
    std::array<std::uint32_t, 2> sizes{};
    if (read_file(std::as_writable_bytes(std::span(sizes))) < sizeof sizes)
        damaged("the file is cut off: expected a chunk");
    const auto [size, compressed_size] = sizes;
    if (size == 0) return false;
    if (size > MaxChunkBytes || compressed_size > ZSTD_compressBound(MaxChunkBytes))
        damaged("expected a chunk of at most " + std::to_string(MaxChunkBytes) +
                " bytes, found one of " + std::to_string(size));
    compressed_.resize(compressed_size);
    if (read_file(compressed_) < compressed_size)
        damaged("the file is cut off: expected a chunk of " + std::to_string(compressed_size) +
                " bytes");
    chunk_.resize(size);
    const std::size_t result =
        ZSTD_decompress(chunk_.data(), size, compressed_.data(), compressed_size);
    if (ZSTD_isError(result) || result != size)
        damaged(ZSTD_isError(result) ? ZSTD_getErrorName(result) : "the chunk is too short");
    return true;
}

void CaptureReader::play_write(Device& device) {
    const std::uint32_t address = take_u32();
    const std::uint32_t bytes = take_u32();
    need_range(address, bytes);
    device.write_memory(address, take(bytes));
}

void CaptureReader::play_read(Device& device) {
    const std::uint32_t address = take_u32();
    const std::uint32_t bytes = take_u32();
    need_range(address, bytes);
    scratch_.resize(bytes);
    device.read_memory(address, scratch_);
}

void CaptureReader::play_commands(Device& device) {
    const std::uint32_t count = take_u32();
    const auto bytes = take(std::size_t{4} * count);
    commands_.words.resize(count);
    std::memcpy(commands_.words.data(), bytes.data(), bytes.size());
    if (const std::string wrong = check_.find_mistake(commands_.words); !wrong.empty())
        damaged(wrong);
    device.submit(commands_);
}

ShownPicture CaptureReader::take_shown() {
    ShownPicture shown;
    shown.frame = take_u32();
    std::array<std::uint32_t, WordCount<Surface>> words{};
    const auto bytes = take(sizeof words);
    std::memcpy(words.data(), bytes.data(), sizeof words);
    shown.picture = unpack<Surface>(words);
    if (const std::string wrong = check_.find_mistake(shown.picture); !wrong.empty())
        damaged(wrong);
    return shown;
}

void CaptureReader::need_range(std::uint32_t address, std::uint64_t bytes) const {
    if (address + bytes > memory_size_)
        damaged("expected addresses within " + std::to_string(memory_size_) + " bytes, found " +
                std::to_string(bytes) + " at " + std::to_string(address));
}

std::uint32_t CaptureReader::take_u32() {
    std::uint32_t value = 0;
    const auto bytes = take(sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

std::span<const std::byte> CaptureReader::take(std::size_t bytes) {
    if (bytes > chunk_.size() - at_) damaged("a record does not end in its chunk");
    const std::size_t at = std::exchange(at_, at_ + bytes);
    return std::span(chunk_).subspan(at, bytes);
}

std::size_t CaptureReader::read_file(std::span<std::byte> bytes) {
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file_.get());
    file_position_ += count;
    return count;
}

void CaptureReader::damaged(const std::string& what) const {
    throw InputError(path_ + ": chunk at byte " + std::to_string(chunk_position_) + ": " + what);
}

} // namespace ffgpu::capture
