#include "model/timing/prepared_work.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace ffgpu::timing {
namespace {

// A quad of the stream, where its texel accesses stand, and the order in which it will come.
struct QuadSource {
    std::uint64_t bin_and_draw = 0; // segment, screen bin, draw
    std::uint32_t primitive = 0;
    std::uint64_t traversal = 0;
    const WorkBatch* batch = nullptr;
    std::uint32_t quad = 0;
    std::uint32_t access_index = 0; // into the batch's index of accesses, see index_accesses
};

std::uint64_t traversal_tile(const RasterConfig& raster, std::uint32_t x, std::uint32_t y) {
    if (raster.traversal != Traversal::Tiled) return 0;
    return std::uint64_t{y / raster.tile_width} << 12 | (x / raster.tile_width);
}

// 48 bits: tile, then row and column (or the other way round) of the quad.
std::uint64_t traversal_key(const RasterConfig& raster, std::uint32_t x, std::uint32_t y) {
    const std::uint64_t row = y / 2, column = x / 2;
    const std::uint64_t place =
        raster.traversal == Traversal::Column ? column << 12 | row : row << 12 | column;
    return traversal_tile(raster, x, y) << 24 | place;
}

std::uint64_t screen_bin(const RasterConfig& raster, std::uint32_t x, std::uint32_t y) {
    if (raster.architecture != Architecture::TileBased) return 0;
    return std::uint64_t{y / raster.bin_size} << 12 | (x / raster.bin_size);
}

struct DrawPlaces {
    const PlacedLevel* depth = nullptr;
    const PlacedLevel* color = nullptr;
    std::array<const std::vector<PlacedLevel>*, TextureUnits> textures{};
};

class Preparer {
public:
    Preparer(const WorkBin& bin, const TimingConfig& config, AddressMap& addresses)
        : bin_(bin)
        , config_(config)
        , addresses_(addresses) {}

    PreparedBin run() {
        prepare_draws();
        collect();
        std::stable_sort(
            sources_.begin(), sources_.end(), [](const QuadSource& a, const QuadSource& b) {
                return std::tie(a.bin_and_draw, a.primitive, a.traversal) <
                       std::tie(b.bin_and_draw, b.primitive, b.traversal);
            });
        out_.quads.reserve(sources_.size());
        for (const QuadSource& source : sources_)
            add_quad(source);
        count_primitives();
        return std::move(out_);
    }

private:
    void prepare_draws() {
        places_.resize(bin_.draws.size());
        for (std::size_t i = 0; i < bin_.draws.size(); ++i) {
            PreparedDraw& draw = out_.draws.emplace_back();
            draw.work = bin_.draws[i];
            add_to_segment(draw);
            if (!draw.work.state) continue;
            const Registers& state = *draw.work.state;
            DrawPlaces& places = places_[i];
            for (unsigned unit = 0; unit < TextureUnits; ++unit) {
                draw.combiners =
                    static_cast<std::uint8_t>(draw.combiners + state.combiners[unit].enable);
                if (state.images[unit].shape.kind == TextureKind::None) continue;
                places.textures[unit] = &addresses_.texture(state.images[unit]);
            }
            if (state.targets.depth.format != Format::None) {
                draw.uses_depth = state.depth.test_enable || state.stencil.enable;
                draw.writes_depth = state.depth.write_enable || state.stencil.enable;
                places.depth = &addresses_.surface(state.targets.depth, config_.depth_cache);
                draw.depth_place = *places.depth;
            }
            if (state.targets.color[0].format != Format::None) {
                const Blend& blend = state.blend;
                draw.writes_color = blend.write_mask != 0;
                draw.reads_color = draw.writes_color && (blend.enable || blend.logic_op_enable ||
                                                         blend.write_mask != 0xf);
                places.color = &addresses_.surface(state.targets.color[0], config_.color_cache);
                draw.color_place = *places.color;
            }
        }
    }

    void add_to_segment(PreparedDraw& draw) {
        const bool streams = draw.work.kind == WorkKind::Draw || draw.work.kind == WorkKind::Image;
        if (out_.segments.empty() || !streams) out_.segments.emplace_back();
        out_.segments.back().draws += streams;
        draw.segment = static_cast<std::uint32_t>(out_.segments.size() - 1);
    }

    void collect() {
        for (const WorkTile& tile : bin_.tiles) {
            for (const WorkBatch& batch : tile.batches) {
                index_accesses(batch);
                for (std::uint32_t q = 0; q < batch.quads.size(); ++q) {
                    const WorkQuad& quad = batch.quads[q];
                    sources_.push_back({
                        .bin_and_draw = std::uint64_t{out_.draws[batch.draw].segment} << 48 |
                                        screen_bin(config_.raster, quad.x, quad.y) << 24 |
                                        batch.draw,
                        .primitive = quad.primitive,
                        .traversal = traversal_key(config_.raster, quad.x, quad.y),
                        .batch = &batch,
                        .quad = q,
                        .access_index = access_base_ + q * units_,
                    });
                }
            }
        }
    }

    // Notes for each quad and unit of a batch where its accesses begin: they are in lane order.
    void index_accesses(const WorkBatch& batch) {
        units_ = static_cast<std::uint32_t>(batch.textures.size());
        access_base_ = static_cast<std::uint32_t>(access_begin_.size());
        access_begin_.resize(access_base_ + batch.quads.size() * units_);
        for (std::uint32_t unit = 0; unit < units_; ++unit) {
            const auto& accesses = batch.textures[unit].accesses;
            std::uint32_t at = 0;
            for (std::uint32_t q = 0; q < batch.quads.size(); ++q) {
                while (at < accesses.size() && accesses[at].lane < 4 * q)
                    ++at;
                access_begin_[access_base_ + q * units_ + unit] = at;
            }
        }
    }

    void add_quad(const QuadSource& source) {
        const WorkQuad& from = source.batch->quads[source.quad];
        const PreparedQuad* before = out_.quads.empty() ? nullptr : &out_.quads.back();
        PreparedQuad quad{.draw = source.batch->draw,
                          .primitive = from.primitive,
                          .x = from.x,
                          .y = from.y,
                          .covered = from.covered,
                          .after_early_depth = from.after_early_depth,
                          .after_stencil = from.after_stencil,
                          .after_depth = from.after_depth,
                          .samples_written = from.samples_written};
        quad.new_tile = !before || before->draw != quad.draw ||
                        before->primitive != quad.primitive ||
                        traversal_tile(config_.raster, before->x, before->y) !=
                            traversal_tile(config_.raster, quad.x, quad.y);
        const DrawPlaces& places = places_[quad.draw];
        add_target_lines(places, quad);
        add_texel_lines(source, places, quad);
        PreparedDraw& draw = out_.draws[quad.draw];
        const auto number = static_cast<std::uint32_t>(out_.quads.size());
        Segment& segment = out_.segments[draw.segment];
        if (segment.quads_end == 0) segment.quads_begin = number;
        segment.quads_end = number + 1;
        if (draw.quad_count++ == 0) draw.first_quad = number;
        out_.quads.push_back(quad);
    }

    void add_target_lines(const DrawPlaces& places, PreparedQuad& quad) {
        quad.target_lines_begin = static_cast<std::uint32_t>(out_.target_lines.size());
        if (places.depth)
            quad.depth_line_count = add_surface_lines(
                *places.depth, config_.depth_cache.line_bytes, quad, quad.covered);
        if (places.color)
            quad.color_line_count = add_surface_lines(
                *places.color, config_.color_cache.line_bytes, quad, quad.after_depth);
    }

    // The lines that hold the samples of `lanes`, each once, in the order of the lanes; returns
    // their number. A quad with one sample a pixel takes one access.
    std::uint8_t add_surface_lines(const PlacedLevel& place,
                                   std::uint32_t line_bytes,
                                   const PreparedQuad& quad,
                                   std::uint8_t lanes) {
        const std::size_t begin = out_.target_lines.size();
        const auto add = [&](std::uint64_t line) {
            const auto first = out_.target_lines.begin() + static_cast<std::ptrdiff_t>(begin);
            if (std::find(first, out_.target_lines.end(), line) == out_.target_lines.end())
                out_.target_lines.push_back(line);
        };
        if (place.samples == 1) {
            add(place.address(quad.x, quad.y, 0) / line_bytes);
            return 1;
        }
        for (unsigned lane = 0; lane < 4; ++lane) {
            if ((lanes >> lane & 1) == 0) continue;
            const std::uint64_t at = place.address(quad.x + (lane & 1u), quad.y + (lane >> 1), 0);
            const std::uint64_t end = at + place.layout.element_bytes;
            for (std::uint64_t line = at / line_bytes; line * line_bytes < end; ++line)
                add(line);
        }
        return static_cast<std::uint8_t>(out_.target_lines.size() - begin);
    }

    void add_texel_lines(const QuadSource& source, const DrawPlaces& places, PreparedQuad& quad) {
        quad.texel_lines_begin = static_cast<std::uint32_t>(out_.texel_lines.size());
        const auto& textures = source.batch->textures;
        unsigned steps = 0;
        for (std::uint32_t i = 0; i < textures.size(); ++i) {
            const auto& accesses = textures[i].accesses;
            const auto* levels = places.textures[textures[i].unit];
            std::array<unsigned, 4> samples{}; // a lane
            for (std::size_t at = access_begin_[source.access_index + i];
                 at < accesses.size() && accesses[at].lane < 4 * (source.quad + 1);
                 ++at) {
                const TexelAccess& access = accesses[at];
                samples[access.lane % 4] += (access.linear & 4) ? 2 : 1;
                if (levels && access.level < levels->size())
                    add_access((*levels)[access.level], access, quad);
            }
            steps += *std::max_element(samples.begin(), samples.end());
        }
        quad.filter_steps = static_cast<std::uint16_t>(std::min(steps, 0xffffu));
        quad.texel_line_count =
            static_cast<std::uint16_t>(out_.texel_lines.size() - quad.texel_lines_begin);
    }

    void add_access(const PlacedLevel& level, const TexelAccess& access, PreparedQuad& quad) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            if (corner & ~unsigned{access.linear})
                continue; // Texels that this filter does not read.
            const std::uint16_t x = corner & 1 ? access.x1 : access.x0;
            const std::uint16_t y = corner & 2 ? access.y1 : access.y0;
            const std::uint16_t layer = corner & 4 ? access.layer1 : access.layer0;
            if (x == TexelAccess::BorderTexel || y == TexelAccess::BorderTexel ||
                layer == TexelAccess::BorderTexel) {
                continue;
            }
            ++quad.texel_reads;
            add_line(level.address(x, y, layer) / config_.texel_cache.line_bytes, quad);
        }
    }

    void add_line(std::uint64_t line, const PreparedQuad& quad) {
        const auto begin = out_.texel_lines.begin() + quad.texel_lines_begin;
        if (std::find(begin, out_.texel_lines.end(), line) == out_.texel_lines.end())
            out_.texel_lines.push_back(line);
    }

    void count_primitives() {
        const PreparedQuad* before = nullptr;
        for (const PreparedQuad& quad : out_.quads) {
            if (!before || before->draw != quad.draw || before->primitive != quad.primitive)
                ++out_.draws[quad.draw].primitives_with_quads;
            before = &quad;
        }
    }

    const WorkBin& bin_;
    const TimingConfig& config_;
    AddressMap& addresses_;
    PreparedBin out_;
    std::vector<DrawPlaces> places_;
    std::vector<QuadSource> sources_;
    std::vector<std::uint32_t> access_begin_;
    std::uint32_t units_ = 0, access_base_ = 0;
};

} // namespace

PreparedBin prepare(const WorkBin& bin, const TimingConfig& config, AddressMap& addresses) {
    return Preparer(bin, config, addresses).run();
}

} // namespace ffgpu::timing
