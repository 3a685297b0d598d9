// FST, GTKWave's compressed waveforms, by GTKWave's own writer, as Verilator brings it.

#include "model/base/input_error.h"
#include "model/base/unfinished_file.h"
#include "model/base/whole_file.h"
#include "tools/export/timeline_format.h"

#ifdef FFGPU_WITH_FST
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <fstapi.h>
#include <malloc.h>
#endif

namespace ffgpu::tools {

#ifdef FFGPU_WITH_FST

namespace {

class Fst final : public TimelineFormat {
public:
    explicit Fst(std::string path)
        : path_(std::move(path))
        , temporary_(unfinished_name(path_))
        , unfinished_(temporary_)
        , unfinished_units_(temporary_ + ".hier")
        , writer_(fstWriterCreate(temporary_.c_str(), 1)) {
        if (!writer_) throw InputError(path_ + ": cannot be written");
        // The writer's large blocks are of all sizes: among kept memory they leave more and more
        // holes.
        ::mallopt(M_MMAP_THRESHOLD, 128 << 10);
    }
    ~Fst() override {
        if (!writer_) return;
        fstWriterClose(writer_);
        std::remove(temporary_.c_str());
    }
    Fst(const Fst&) = delete;
    Fst& operator=(const Fst&) = delete;

    void begin(const std::vector<std::string>& units) override {
        fstWriterSetPackType(writer_, FST_WR_PT_LZ4);
        fstWriterSetDate(writer_, ""); // Equal work gives equal files.
        fstWriterSetVersion(writer_, "ffgpu");
        fstWriterSetTimescale(writer_, -9);
        fstWriterSetComment(writer_, legend().c_str());
        fstWriterSetScope(writer_, FST_ST_VCD_MODULE, "ffgpu", nullptr);
        for (const std::string& unit : units) {
            fstWriterSetScope(writer_, FST_ST_VCD_MODULE, unit.c_str(), nullptr);
            variables_.push_back(
                fstWriterCreateVar(writer_, FST_VT_VCD_WIRE, FST_VD_IMPLICIT, Bits, "activity", 0));
            fstWriterSetUpscope(writer_);
        }
        fstWriterSetUpscope(writer_);
        fstWriterEmitTimeChange(writer_, 0);
        for (std::size_t unit = 0; unit < units.size(); ++unit)
            value(unit, timing::Activity::Idle);
    }

    void change(std::size_t unit, timing::Activity activity, std::uint64_t time) override {
        if (time > time_) fstWriterEmitTimeChange(writer_, time);
        time_ = time;
        value(unit, activity);
        if (++waiting_ < MostWaiting) return;
        fstWriterFlushContext(writer_); // where time goes on
        waiting_ = 0;
        // What the writer let go of at the flush before: large blocks of all sizes, of which the
        // allocator would keep more and more.
        ::malloc_trim(0);
    }

    // The writer does not say where a disk was full: what was written is looked at.
    void end(std::uint64_t time) override {
        if (time > time_) fstWriterEmitTimeChange(writer_, time);
        fstWriterClose(std::exchange(writer_, nullptr));
        void* const reader = fstReaderOpen(temporary_.c_str());
        const bool whole = reader && fstReaderGetEndTime(reader) == time &&
                           fstReaderGetVarCount(reader) == variables_.size();
        if (reader) fstReaderClose(reader);
        std::error_code error;
        if (whole) std::filesystem::rename(temporary_, path_, error);
        if (whole && !error) return;
        std::remove(temporary_.c_str());
        throw InputError(path_ + ": cannot be written whole: is the disk full?");
    }

private:
    static constexpr std::uint32_t Bits = 3;
    // Changes that the writer keeps in memory: by itself it waits for 128 MB of them.
    static constexpr std::uint32_t MostWaiting = 1u << 19;

    static std::string legend() {
        std::string text = "a unit of time is a cycle; activity:";
        for (std::size_t i = 0; i < timing::ActivityNames.size(); ++i)
            text += fmt::format(" {} {}", i, timing::ActivityNames[i]);
        return text;
    }

    void value(std::size_t unit, timing::Activity activity) {
        fstWriterEmitValueChange32(
            writer_, variables_[unit], Bits, static_cast<std::uint32_t>(activity));
    }

    std::string path_, temporary_;
    UnfinishedFile unfinished_, unfinished_units_; // The writer keeps the units in a file beside.
    void* writer_;
    std::vector<fstHandle> variables_;
    std::uint64_t time_ = 0;
    std::uint32_t waiting_ = 0;
};

} // namespace

std::unique_ptr<TimelineFormat> make_fst(const std::string& path) {
    if (path == "-") throw InputError("--format fst: expected -o FILE: it is not written in order");
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
        throw InputError(path + ": is no regular file, as --format fst needs: it is not written in "
                                "order");
    return std::make_unique<Fst>(path);
}

#else

std::unique_ptr<TimelineFormat> make_fst(const std::string&) {
    throw InputError("--format fst: this build has no writer of FST: it is Verilator's "
                     "(Debian: verilator); vcd holds the same");
}

#endif

} // namespace ffgpu::tools
