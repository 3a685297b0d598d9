// apitrace's own container: 'a' 't', then blocks of (length as u32, raw Snappy block); a length of
// 0 or the end of the file ends it. It is not Snappy's framing format.

#include "driver/trace/reader/container.h"
#include "driver/trace/reader/damage.h"
#include "driver/trace/reader/input_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <snappy-sinksource.h>
#include <snappy.h>

namespace ffgpu::trace {
namespace {

// A Snappy copy of 3 bytes stands for 64 at most, so that a larger claim is a lie.
constexpr std::uint64_t MaxExpansion = 64;

// Snappy's own sink for "as much as possible", into the chunk.
class ChunkSink : public snappy::Sink {
public:
    explicit ChunkSink(std::vector<std::byte>& chunk)
        : chunk_(chunk) {}
    void Append(const char* bytes, std::size_t count) override {
        const auto* begin = reinterpret_cast<const std::byte*>(bytes);
        chunk_.insert(chunk_.end(), begin, begin + count);
    }

private:
    std::vector<std::byte>& chunk_;
};

class SnappyContainer : public Container {
public:
    explicit SnappyContainer(std::unique_ptr<InputFile> file)
        : file_(std::move(file)) {
        rewind();
    }

    void rewind() override {
        std::array<std::byte, 2> magic{};
        file_->rewind();
        file_->read(magic);
        damage_.clear();
    }

    bool next(std::vector<std::byte>& chunk) override {
        std::vector<std::byte> former; // written over: one that was cleared would be filled first
        former.swap(chunk);
        if (!damage_.empty()) throw Damage{damage_};
        const std::uint64_t at = file_->position();
        const std::uint32_t length = read_length();
        if (length == 0) return false;
        read_block(length);
        if (block_.size() < length) {
            damage_ = "the file is cut off: its Snappy block at byte " + std::to_string(at) +
                      " needs " + std::to_string(length - block_.size()) + " more bytes";
            decode_part(chunk);
        } else if (decode(former)) {
            chunk.swap(former);
        } else {
            damage_ = "the file's Snappy block at byte " + std::to_string(at) + " is damaged";
            decode_part(chunk);
        }
        if (chunk.empty() && !damage_.empty()) throw Damage{damage_};
        return true;
    }

private:
    std::uint32_t read_length() {
        std::array<std::byte, 4> bytes{};
        const std::size_t count = file_->read(bytes);
        if (count == 0) return 0;
        if (count < bytes.size())
            throw Damage{"the file is cut off in the length of a Snappy block"};
        std::uint32_t length = 0;
        for (unsigned i = 0; i < 4; ++i)
            length |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
        return length;
    }

    // In steps, so that memory grows with the file and not with the claim.
    void read_block(std::size_t length) {
        constexpr std::size_t Step = std::size_t{1} << 22;
        block_.clear();
        while (block_.size() < length) {
            const std::size_t have = block_.size();
            const std::size_t step = std::min(Step, length - have);
            block_.resize(have + step);
            const std::size_t count = file_->read(std::span(block_).subspan(have));
            block_.resize(have + count);
            if (count < step) return;
        }
    }

    const char* block() const { return reinterpret_cast<const char*>(block_.data()); }

    bool claim_is_possible(std::size_t& size) const {
        return snappy::GetUncompressedLength(block(), block_.size(), &size) &&
               size <= MaxExpansion * block_.size();
    }

    bool decode(std::vector<std::byte>& chunk) const {
        std::size_t size = 0;
        if (!claim_is_possible(size)) return false;
        chunk.resize(size);
        return snappy::RawUncompress(block(), block_.size(), reinterpret_cast<char*>(chunk.data()));
    }

    void decode_part(std::vector<std::byte>& chunk) const {
        chunk.clear();
        snappy::ByteArraySource source(block(), block_.size());
        ChunkSink sink(chunk);
        snappy::UncompressAsMuchAsPossible(&source, &sink);
    }

    std::unique_ptr<InputFile> file_;
    std::vector<std::byte> block_;
    std::string damage_; // Found already, to be reported after the bytes before it.
};

} // namespace

std::unique_ptr<Container> open_snappy(std::unique_ptr<InputFile> file) {
    return std::make_unique<SnappyContainer>(std::move(file));
}

} // namespace ffgpu::trace
