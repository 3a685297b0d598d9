#include "model/work/command_assembler.h"

#include "model/packets/fragment_key.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace ffgpu::work {
namespace {

// Where the accesses of each quad and unit of a batch begin: they are in the order of lanes.
class AccessIndex {
public:
    explicit AccessIndex(const WorkBatch& batch)
        : units_(batch.textures.size())
        , begin_((batch.quads.size() + 1) * units_) {
        for (std::size_t unit = 0; unit < units_; ++unit) {
            const auto& accesses = batch.textures[unit].accesses;
            std::uint32_t at = 0;
            for (std::size_t quad = 0; quad <= batch.quads.size(); ++quad) {
                while (at < accesses.size() && accesses[at].lane < 4 * quad)
                    ++at;
                begin_[quad * units_ + unit] = at;
            }
        }
    }

    std::uint32_t begin(std::size_t quad, std::size_t unit) const {
        return begin_[quad * units_ + unit];
    }

private:
    std::size_t units_;
    std::vector<std::uint32_t> begin_;
};

// A quad of a batch, by what brings it into the canonical order within its primitive.
struct Source {
    std::uint64_t piece_and_place = 0; // piece, row, column
    std::uint32_t batch = 0;
    std::uint32_t quad = 0;

    std::uint32_t piece() const { return static_cast<std::uint32_t>(piece_and_place >> 32); }

    // Quads of one place stay in the order in which they came.
    bool operator<(const Source& other) const {
        if (piece_and_place != other.piece_and_place)
            return piece_and_place < other.piece_and_place;
        return std::pair(batch, quad) < std::pair(other.batch, other.quad);
    }
};

Source source(const WorkQuad& quad, std::uint32_t batch, std::uint32_t number) {
    const std::uint32_t place = static_cast<std::uint32_t>(quad.y) << 16 | quad.x;
    return {std::uint64_t{quad.piece} << 32 | place, batch, number};
}

// The quads of one place of an image, each drawn by another of its pixels, become pieces.
void number_image_pieces(std::vector<Source>& sources) {
    constexpr std::uint64_t OnePiece = std::uint64_t{1} << 32;
    for (std::size_t i = 1; i < sources.size(); ++i)
        if ((sources[i].piece_and_place - sources[i - 1].piece_and_place) % OnePiece == 0)
            sources[i].piece_and_place = sources[i - 1].piece_and_place + OnePiece;
}

template <class Each>
void for_each_quad(std::span<const WorkBatch* const> batches, Each&& each) {
    for (std::uint32_t batch = 0; batch < batches.size(); ++batch)
        for (std::uint32_t q = 0; q < batches[batch]->quads.size(); ++q)
            each(batches[batch]->quads[q], batch, q);
}

// By primitives at first, whose numbers are small: each has few quads then.
std::vector<Source> in_canonical_order(std::span<const WorkBatch* const> batches, bool is_image) {
    std::vector<std::uint32_t> begin; // of the primitive's quads; then the end
    for_each_quad(batches, [&](const WorkQuad& quad, std::uint32_t, std::uint32_t) {
        if (quad.primitive + std::size_t{2} > begin.size()) begin.resize(quad.primitive + 2u, 0);
        ++begin[quad.primitive + 1];
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Source> sources(begin.empty() ? 0 : begin.back());
    for_each_quad(batches, [&](const WorkQuad& quad, std::uint32_t batch, std::uint32_t q) {
        sources[begin[quad.primitive]++] = source(quad, batch, q);
    });
    std::uint32_t first = 0;
    for (const std::uint32_t end : begin) {
        std::sort(sources.begin() + first, sources.begin() + end);
        first = end;
    }
    if (is_image) {
        number_image_pieces(sources);
        std::sort(sources.begin(), sources.end());
    }
    return sources;
}

// Appends what the batch's quad read, lanes counted in the quad.
void append_accesses(const WorkBatch& batch,
                     const AccessIndex& index,
                     std::uint32_t quad,
                     WholeCommand& whole) {
    for (const std::uint8_t unit : whole.units) {
        for (std::size_t i = 0; i < batch.textures.size(); ++i) {
            if (batch.textures[i].unit != unit) continue;
            const TexelAccess* const accesses = batch.textures[i].accesses.data();
            const std::size_t first = whole.accesses.size();
            whole.accesses.insert(whole.accesses.end(),
                                  accesses + index.begin(quad, i),
                                  accesses + index.begin(quad + 1, i));
            for (TexelAccess& access : std::span(whole.accesses).subspan(first))
                access.lane %= 4;
        }
        whole.access_begin.push_back(static_cast<std::uint32_t>(whole.accesses.size()));
    }
}

void append_values(const WorkBatch& batch, std::uint32_t quad, WholeCommand& whole) {
    const auto at = [&](std::uint32_t q) {
        return batch.values.begin() + static_cast<std::ptrdiff_t>(batch.value_begin[q]);
    };
    whole.values.insert(whole.values.end(), at(quad), at(quad + 1));
    whole.value_begin.push_back(static_cast<std::uint32_t>(whole.values.size()));
}

std::size_t count_accesses(std::span<const WorkBatch* const> batches) {
    std::size_t accesses = 0;
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            accesses += unit.accesses.size();
    return accesses;
}

std::vector<std::uint8_t> units_of(std::span<const WorkBatch* const> batches) {
    std::array<bool, TextureUnits> used{};
    for (const WorkBatch* const batch : batches)
        for (const TexelFootprints& unit : batch->textures)
            used[unit.unit] = used[unit.unit] || !unit.accesses.empty();
    std::vector<std::uint8_t> units;
    for (std::uint8_t unit = 0; unit < TextureUnits; ++unit)
        if (used[unit]) units.push_back(unit);
    return units;
}

} // namespace

void CommandAssembler::draw(const WorkDraw& draw, std::span<const WorkBatch* const> batches) {
    auto whole = std::make_shared<WholeCommand>();
    whole->draw = draw;
    whole->units = units_of(batches);
    std::vector<AccessIndex> indices;
    indices.reserve(batches.size());
    for (const WorkBatch* const batch : batches)
        indices.emplace_back(*batch);
    const std::vector<Source> sources = in_canonical_order(batches, draw.kind == WorkKind::Image);
    whole->quads.reserve(sources.size());
    whole->access_begin.reserve(sources.size() * whole->units.size() + 1);
    whole->accesses.reserve(count_accesses(batches));
    const bool has_values = !sources.empty() && !batches[0]->value_begin.empty();
    if (has_values) whole->value_begin.push_back(0);
    for (const Source& source : sources) {
        const WorkBatch& batch = *batches[source.batch];
        whole->quads.push_back(batch.quads[source.quad]);
        whole->quads.back().piece = source.piece();
        append_accesses(batch, indices[source.batch], source.quad, *whole);
        if (has_values) append_values(batch, source.quad, *whole);
    }
    out_.command(std::move(whole));
}

} // namespace ffgpu::work
