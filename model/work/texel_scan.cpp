#include "model/work/texel_scan.h"

#include "model/base/sort_by_digits.h"
#include "model/work/draw_places.h"
#include "model/work/target_clear.h"
#include "model/work/traversal.h"

#include <algorithm>
#include <tuple>

namespace ffgpu::work {
namespace {

// Keys of a run lie so close that runs of one piece seldom reach into each other.
constexpr unsigned RunKeyBits = 4;
// Fewer runs are compared: a pass over digits begins with a table of up to 2,048 places.
constexpr std::size_t FewRuns = 256;
// Of a primitive, in the mean: fewer are compared, in the cache that they fit into.
constexpr std::size_t ManyRuns = 64;

} // namespace

struct TexelScan::Places {
    TexelScan& to;

    void texture(unsigned unit, const std::shared_ptr<const TextureLines>& texture) const {
        to.textures_[unit] = texture.get(); // The map holds them.
    }
    void depth(const PlacedLevel&) const {}
    void color(std::uint8_t, const PlacedLevel&) const {}
};

TexelScan::TexelScan(const WorkConfig& config, LookupSink& out)
    : config_(config)
    , out_(out)
    , keys_(config.raster)
    , addresses_(config.texel_cache)
    , lines_of_quad_(config.texel_cache.line_bytes, config.merges_texel_reads) {}

// --- The commands --------------------------------------------------------------------------------

void TexelScan::draw_part(const WorkDraw& draw, const DrawPart& part) {
    if (!begun_ && !begin(draw)) return;
    begun_ = !part.last;
    for (const WorkBatch* const batch : part.batches) {
        drawn_texels_.add(batch->quads);
        add(*batch);
    }
    if (!part.last) return;
    if (draw.kind == WorkKind::Image) number_image_pieces();
    tell();
}

void TexelScan::command(std::shared_ptr<const WholeCommand> command) {
    if (!begin(command->draw)) return;
    drawn_texels_.add(command->quads);
    for (std::size_t number = 0; number < command->quads.size(); ++number) {
        const unsigned lanes = test_.after_early_test(command->quads[number]);
        lines_of_quad_.begin_quad();
        for (std::size_t i = 0; i < command->units.size(); ++i)
            for (const TexelAccess& access : command->accesses_of(number, i))
                add(access, lanes, *textures_[command->units[i]]);
        end_quad(command->quads[number]);
    }
    tell();
}

// Returns whether it has quads.
bool TexelScan::begin(const WorkDraw& draw) {
    if (draw.kind == WorkKind::Clear || draw.kind == WorkKind::Copy) {
        place_others(draw);
        return false;
    }
    static const TextureLines nothing;
    textures_.fill(&nothing);
    const Places places{*this};
    if (draw.state) {
        tell_rewritten(drawn_texels_.take(*draw.state), out_);
        drawn_texels_.begin(draw);
        place_draw(*draw.state, config_, addresses_, places);
    }
    test_ = depth_test_place(draw, config_.depth_test);
    quads_.clear();
    lines_.clear();
    runs_.clear();
    first_ = true;
    return true;
}

// Textures lie behind the surfaces that were used before.
void TexelScan::place_others(const WorkDraw& draw) {
    const auto shape = [&](bool depth) -> const CacheShape& {
        return depth ? config_.depth_cache : config_.color_cache;
    };
    if (draw.kind == WorkKind::Clear) {
        drawn_texels_.clear(draw);
        for (const TargetClear& of : target_clears(draw))
            if (is_asked_for(draw.clear, of.depth)) addresses_.surface(of.target, shape(of.depth));
        return;
    }
    const CopyRectangleCommand& copy = draw.copy;
    const CacheShape& cache = shape(format_info(copy.source.format).is_depth);
    addresses_.surface(copy.source, cache);
    for (unsigned i = 1; i < copy.pictures; ++i)
        addresses_.surface(copy.source.plane(i), cache);
    addresses_.surface(copy.destination, cache);
    tell_rewritten(addresses_.copied(copy), out_);
}

void TexelScan::content(const std::shared_ptr<const SurfaceContent>& content) {
    const Surface& surface = content->surface;
    const bool depth = format_info(surface.format).is_depth;
    addresses_.surface(surface, depth ? config_.depth_cache : config_.color_cache);
}

void TexelScan::host_transfer(const HostTransfer& transfer) {
    if (transfer.is_write)
        tell_rewritten(addresses_.memory_written(transfer.at, transfer.bytes), out_);
}

void TexelScan::end_frame(std::uint32_t frame) {
    out_.end_frame(frame);
    place_.begin(Reuse::Frame);
}

// --- The quads of a draw -------------------------------------------------------------------------

FragmentMask TexelScan::lanes_of(const WorkBatch& batch) const {
    FragmentMask lanes;
    for (std::size_t number = 0; number < batch.quads.size(); ++number)
        lanes.words[number / 16] |= std::uint64_t{test_.after_early_test(batch.quads[number])}
                                    << 4 * (number % 16);
    return lanes;
}

void TexelScan::add(const WorkBatch& batch) {
    if (!config_.merges_texel_reads) return add_each_read(batch);
    reads_.set(batch, lanes_of(batch), textures_);
    for (unsigned number = 0; number < batch.quads.size(); ++number) {
        if (reads_.repeats(number)) {
            add(batch.quads[number], quads_.back().begin, reads_.reads(number));
            continue;
        }
        lines_of_quad_.begin_quad();
        reads_.add_quad(number, lines_of_quad_);
        end_quad(batch.quads[number]);
    }
}

void TexelScan::add_each_read(const WorkBatch& batch) {
    for (std::uint32_t number = 0; number < batch.quads.size(); ++number) {
        const unsigned lanes = test_.after_early_test(batch.quads[number]);
        lines_of_quad_.begin_quad();
        for (const TexelFootprints& unit : batch.textures)
            for (const TexelAccess& access : unit.of_quad(number))
                add(access, lanes, *textures_[unit.unit]);
        end_quad(batch.quads[number]);
    }
}

void TexelScan::end_quad(const WorkQuad& quad) {
    if (lines_of_quad_.lines().empty()) return;
    const auto first_line = static_cast<std::uint32_t>(lines_.size());
    for (const std::uint64_t line : lines_of_quad_.lines())
        lines_.push_back({line, false});
    add(quad, first_line, lines_of_quad_.reads());
}

// Inlined: it is called for each quad.
[[gnu::always_inline]] inline void TexelScan::add_to_runs(std::uint32_t quad) {
    const Quad& own = quads_[quad];
    if (!runs_.empty()) {
        Run& run = runs_.back();
        if (own.piece == run.piece && own.key > quads_[quad - 1].key &&
            own.key >> RunKeyBits == run.key >> RunKeyBits) {
            run.end = quad + 1;
            return;
        }
    }
    runs_.push_back({own.piece, own.key, quad, quad + 1});
}

// With the lines from the first one on.
void TexelScan::add(const WorkQuad& quad, std::uint32_t first_line, std::uint32_t reads) {
    quads_.push_back({.piece = std::uint64_t{quad.primitive} << 32 | quad.piece,
                      .key = keys_(quad.x, quad.y),
                      .begin = first_line,
                      .end = static_cast<std::uint32_t>(lines_.size()),
                      .reads = reads});
    add_to_runs(static_cast<std::uint32_t>(quads_.size() - 1));
}

// --- In the raster order -------------------------------------------------------------------------

bool TexelScan::runs_overlap() const {
    for (std::size_t i = 1; i < runs_.size(); ++i)
        if (runs_[i - 1].piece == runs_[i].piece &&
            quads_[runs_[i - 1].end - 1].key >= runs_[i].key)
            return true;
    return false;
}

bool TexelScan::Run::before(const Run& a, const Run& b) {
    return std::tie(a.piece, a.key, a.begin) < std::tie(b.piece, b.key, b.begin);
}

void TexelScan::order_runs() {
    if (std::is_sorted(runs_.begin(), runs_.end(), Run::before)) return;
    if (runs_.size() < FewRuns) {
        std::sort(runs_.begin(), runs_.end(), Run::before);
        return;
    }
    const auto primitive = [](const Run& run) { return run.piece >> 32; };
    sort_by_digits(runs_, spare_runs_, primitive);
    std::size_t primitives = 1;
    for (std::size_t i = 1; i < runs_.size(); ++i)
        primitives += primitive(runs_[i - 1]) != primitive(runs_[i]);
    if (runs_.size() / primitives > ManyRuns) {
        sort_by_digits(runs_, spare_runs_, [](const Run& run) { return run.key; });
        sort_by_digits(runs_, spare_runs_, [](const Run& run) {
            return static_cast<std::uint32_t>(run.piece);
        });
        sort_by_digits(runs_, spare_runs_, primitive);
        return;
    }
    for (auto begin = runs_.begin(); begin != runs_.end();) {
        const auto of_another = [&](const Run& run) { return primitive(run) != primitive(*begin); };
        const auto end = std::find_if(begin, runs_.end(), of_another);
        if (end - begin > 1) std::sort(begin, end, Run::before);
        begin = end;
    }
}

// Runs that reach into each other stand behind each other, and become runs of a quad each.
void TexelScan::take_apart_overlapping_runs() {
    spare_runs_.clear();
    for (auto begin = runs_.begin(); begin != runs_.end();) {
        auto end = begin + 1;
        std::uint32_t last_key = quads_[begin->end - 1].key;
        for (; end != runs_.end() && end->piece == begin->piece && end->key <= last_key; ++end)
            last_key = std::max(last_key, quads_[end->end - 1].key);
        const auto added = static_cast<std::ptrdiff_t>(spare_runs_.size());
        if (end - begin == 1) {
            spare_runs_.push_back(*begin);
        } else {
            for (auto run = begin; run != end; ++run)
                for (std::uint32_t quad = run->begin; quad < run->end; ++quad)
                    spare_runs_.push_back({run->piece, quads_[quad].key, quad, quad + 1});
            std::sort(spare_runs_.begin() + added, spare_runs_.end(), Run::before);
        }
        begin = end;
    }
    runs_.swap(spare_runs_);
}

// Quads of one place stay in the order in which they came.
void TexelScan::sort_runs() {
    order_runs();
    if (runs_overlap()) take_apart_overlapping_runs();
}

// The quads of one place of an image, each drawn by another of its pixels, become pieces.
void TexelScan::number_image_pieces() {
    sort_runs();
    const Quad* last = nullptr;
    for (const Run& run : runs_)
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
            Quad& quad = quads_[i];
            if (last && last->key == quad.key) quad.piece = last->piece + 1;
            last = &quad;
        }
    runs_.clear();
    for (std::uint32_t quad = 0; quad < quads_.size(); ++quad)
        add_to_runs(quad);
}

void TexelScan::tell() {
    sort_runs();
    for (const Run& run : runs_)
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            tell(quads_[i]);
}

void TexelScan::tell(const Quad& quad) {
    const std::uint32_t block = quad.key >> block_key_bits(config_.raster);
    const Reuse since = first_                                    ? Reuse::Draw
                        : quad.piece >> 32 != piece_ >> 32        ? Reuse::Primitive
                        : quad.piece != piece_ || block != block_ ? Reuse::Tile
                                                                  : Reuse::Quad;
    place_.begin(since);
    const auto lines = std::span(lines_).subspan(quad.begin, quad.end - quad.begin);
    if (since == Reuse::Quad && quad.begin == first_line_)
        out_.same_lookups(place_, lines, quad.reads);
    else
        out_.lookups(LookupClient::Texel, place_, lines, quad.reads);
    first_ = false;
    piece_ = quad.piece;
    block_ = block;
    first_line_ = quad.begin;
    ++place_.number;
}

} // namespace ffgpu::work
