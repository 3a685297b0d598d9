// Zstandard frames one after the other. apitrace's seekable form is the same with a table in a
// skippable frame at the end, which the library skips.

#include "driver/trace/reader/container.h"
#include "driver/trace/reader/damage.h"
#include "driver/trace/reader/input_file.h"
#include "model/base/check.h"

#include <zstd.h>

namespace ffgpu::trace {
namespace {

constexpr std::size_t ChunkBytes = std::size_t{1} << 20;

class ZstdContainer : public Container {
public:
    explicit ZstdContainer(std::unique_ptr<InputFile> file)
        : file_(std::move(file))
        , stream_(ZSTD_createDStream())
        , storage_(ZSTD_DStreamInSize()) {
        check(stream_ != nullptr, "Zstandard cannot be initialised");
    }
    ~ZstdContainer() override { ZSTD_freeDStream(stream_); }
    ZstdContainer(const ZstdContainer&) = delete;
    ZstdContainer& operator=(const ZstdContainer&) = delete;

    void rewind() override {
        file_->rewind();
        ZSTD_DCtx_reset(stream_, ZSTD_reset_session_only);
        input_ = {};
        between_frames_ = true;
        damage_.clear();
    }

    bool next(std::vector<std::byte>& chunk) override {
        chunk.clear();
        if (!damage_.empty()) throw Damage{damage_};
        chunk.resize(ChunkBytes);
        ZSTD_outBuffer output{chunk.data(), chunk.size(), 0};
        while (output.pos < output.size && damage_.empty() && refill())
            step(output);
        chunk.resize(output.pos);
        if (chunk.empty() && !damage_.empty()) throw Damage{damage_};
        return !chunk.empty();
    }

private:
    bool refill() {
        if (input_.pos < input_.size) return true;
        input_ = {storage_.data(), file_->read(storage_), 0};
        if (input_.size > 0) return true;
        if (!between_frames_) damage_ = "the file is cut off: its Zstandard frame does not end";
        return false;
    }

    void step(ZSTD_outBuffer& output) {
        const std::size_t result = ZSTD_decompressStream(stream_, &output, &input_);
        if (ZSTD_isError(result))
            damage_ = "the file's Zstandard stream is damaged before byte " +
                      std::to_string(file_->position()) + ": " + ZSTD_getErrorName(result);
        between_frames_ = result == 0;
    }

    std::unique_ptr<InputFile> file_;
    ZSTD_DStream* stream_;
    std::vector<std::byte> storage_;
    ZSTD_inBuffer input_{};
    bool between_frames_ = true;
    std::string damage_; // Found already, to be reported after the bytes before it.
};

} // namespace

std::unique_ptr<Container> open_zstd(std::unique_ptr<InputFile> file) {
    return std::make_unique<ZstdContainer>(std::move(file));
}

} // namespace ffgpu::trace
