#include "driver/trace/reader/container.h"
#include "driver/trace/reader/damage.h"
#include "driver/trace/reader/input_file.h"
#include "model/base/check.h"

#include <zlib.h>

namespace ffgpu::trace {
namespace {

constexpr std::size_t ChunkBytes = std::size_t{1} << 20;

class GzipContainer : public Container {
public:
    explicit GzipContainer(std::unique_ptr<InputFile> file)
        : file_(std::move(file))
        , input_(ChunkBytes / 4) {
        constexpr int GzipOnly = 15 + 16;
        check(inflateInit2(&stream_, GzipOnly) == Z_OK, "zlib cannot be initialised");
    }
    ~GzipContainer() override { inflateEnd(&stream_); }
    GzipContainer(const GzipContainer&) = delete;
    GzipContainer& operator=(const GzipContainer&) = delete;

    void rewind() override {
        file_->rewind();
        inflateReset(&stream_);
        stream_.avail_in = 0;
        at_end_ = false;
        damage_.clear();
    }

    bool next(std::vector<std::byte>& chunk) override {
        chunk.clear();
        if (!damage_.empty()) throw Damage{damage_};
        if (at_end_) return false;
        chunk.resize(ChunkBytes);
        stream_.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream_.avail_out = static_cast<uInt>(chunk.size());
        while (stream_.avail_out > 0 && !at_end_ && damage_.empty())
            step();
        chunk.resize(chunk.size() - stream_.avail_out);
        if (chunk.empty() && !damage_.empty()) throw Damage{damage_};
        return !chunk.empty();
    }

private:
    bool refill() {
        if (stream_.avail_in > 0) return true;
        stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
        stream_.avail_in = static_cast<uInt>(file_->read(input_));
        return stream_.avail_in > 0;
    }

    void step() {
        if (!refill()) {
            damage_ = "the file is cut off: its gzip stream does not end";
            return;
        }
        const int result = inflate(&stream_, Z_NO_FLUSH);
        if (result == Z_STREAM_END) {
            // Another member may follow (RFC 1952, 2.2).
            if (refill())
                inflateReset(&stream_);
            else
                at_end_ = true;
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            damage_ = "the file's gzip stream is damaged before byte " +
                      std::to_string(file_->position() - stream_.avail_in);
        }
    }

    std::unique_ptr<InputFile> file_;
    std::vector<std::byte> input_;
    z_stream stream_{};
    bool at_end_ = false;
    std::string damage_; // Found already, to be reported after the bytes before it.
};

} // namespace

std::unique_ptr<Container> open_gzip(std::unique_ptr<InputFile> file) {
    return std::make_unique<GzipContainer>(std::move(file));
}

} // namespace ffgpu::trace
