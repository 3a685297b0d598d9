// TexturePipe: the texture units of one fragment pipe. Quads wait for them in a queue, so that a
// pipe that is behind does not hold up the others at once.

#pragma once

#include "model/base/ring.h"
#include "model/base/statistics.h"
#include "model/timing/fragment_pipes.h"
#include "model/timing/parked_quads.h"
#include "model/timing/quad_observer.h"
#include "model/timing/texel_requests.h"
#include "model/timing/texel_stream.h"
#include "model/timing/texture_share.h"

namespace ffgpu::timing {

class TextureStatistics : public StatisticsGroup {
public:
    Counter& quads = count("texture_quads", "quads", "with at least one sample");
    Counter& texel_reads = count(
        "texture_texel_reads", "texels", "read by the filters, before reads of a line are merged");
    Counter& samples =
        count("texture_bilinear_samples", "quads", "bilinear or simpler samples filtered");
};

class TexturePipe {
public:
    TexturePipe(const TimingConfig& config, LineCache& cache)
        : config_(config)
        , cache_(cache)
        , share_(config.texture, config.texel_cache)
        , requests_(config.texture)
        , stream_(config.texture, cache, config.texel_cache.outstanding_lines) {}

    bool can_take(const QuadToken& quad) const {
        return waiting_.size() + stream_.quads() < config_.fragment.pipe_queue &&
               (config_.texture.rate == TexelRate::Samples || requests_.can_take(quad));
    }
    void take(const QuadToken& quad) {
        if (config_.texture.rate == TexelRate::Texels) requests_.take(quad);
        waiting_.push_back(quad);
        ++to_tags_.entered;
        ++inside_.entered;
    }
    void set_observer(QuadObserver* observer) { observer_ = observer; }

    // Quads that wait for the tags, or with their texels for the filter.
    bool has_backlog() const {
        return !waiting_.empty() || (parked_.size() > 1 && cache_.is_complete(parked_[1].ticket));
    }

    // Some cycles have to pass before a quad whose texels are there can be filtered.
    bool expands_texels() const {
        return stream_.waits() || requests_.moves() ||
               (config_.texel_cache.decompress_cycles > 0 && !parked_.empty() &&
                (read_ > 0 || cache_.is_complete(parked_.front().ticket)));
    }

    std::string state() const;

    bool has_parked() const { return !parked_.empty() || stream_.quads() > 0; }
    bool has_tags_to_compare() const {
        return comparing_ || miss_cycles_left_ > 0 || !waiting_.empty() || stream_.is_comparing() ||
               requests_.moves();
    }

    // With TexelRate::Samples: there is nothing to do before texels come, or a quad.
    bool rests() const {
        return !has_tags_to_compare() && read_ == 0 &&
               (parked_.empty() || !cache_.is_complete(parked_.front().ticket));
    }

    // From the way in to the tags, and from there to the filter; with TexelRate::Texels texels go
    // there, not quads.
    const Passage& to_tags() const { return to_tags_; }
    const Passage& to_filter() const { return to_filter_; }
    // With TexelRate::Texels: from the data to the way out, and from the way in to there.
    const Passage& to_exit() const { return to_exit_; }
    const Passage& inside() const { return inside_; }

    // One cycle's work of each part, which has some; false, and the reason, where it did none.
    bool compare_tags(TextureStatistics& statistics, Cycle now, Activity& reason);
    bool filter(PipeExit& out, std::size_t pipe, Cycle now, Activity& reason);

private:
    // The fragment FIFO's quads: their texels are read when all their lines have come, and can be
    // filtered when they are expanded.
    struct Parked {
        QuadToken quad;
        std::uint64_t ticket = 0;
        Cycle ready_at = 0;
    };

    bool compare(TextureStatistics& statistics, Cycle now, Activity& reason);
    bool begin(TextureStatistics& statistics, Activity& reason);
    bool stream_tags(TextureStatistics& statistics, Cycle now, Activity& reason);
    bool stream_data(PipeExit& out, std::size_t pipe, Cycle now, Activity& reason);
    static void count(TextureStatistics& statistics, const PreparedQuad& quad);
    void read_texels(Cycle now);

    const TimingConfig& config_;
    LineCache& cache_;
    Ring<QuadToken> waiting_;
    TextureShare share_;
    bool comparing_ = false;  // current_ is between its first and its last tag
    bool lacks_port_ = false; // its next tag's bank
    QuadToken current_;
    std::uint64_t ticket_ = 0;
    std::uint32_t miss_cycles_left_ = 0;
    Ring<Parked> parked_;
    std::size_t read_ = 0; // parked quads whose texels were read
    std::uint32_t filter_cycles_left_ = 0;
    bool filtering_ = false;
    QuadObserver* observer_ = nullptr;
    TexelRequests requests_; // TexelRate::Texels
    TexelStream stream_;     // and these
    Passage to_tags_, to_filter_, to_exit_, inside_;
};

} // namespace ffgpu::timing
