#include "model/timing/block_states.h"

#include "model/base/check.h"

#include <algorithm>
#include <cstring>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t StencilMask = 0xff, DepthMask = 0xffffff00;

std::uint32_t pixel_mask(Format format) {
    const unsigned bits = 8u * format_info(format).block_bytes;
    return bits == 32 ? ~std::uint32_t{0} : (1u << bits) - 1;
}

bool is_constant(const work::SurfaceFill& fill) {
    for (std::uint32_t i = 0; i < 16; ++i)
        if (fill.value_at(i % 4, i / 4) != fill.value_at(0, 0)) return false;
    return true;
}

std::uint32_t depth_of(Format format, std::uint32_t word) {
    return format == Format::Depth16 ? word : word >> 8;
}

} // namespace

BlockStates::BlockStates(std::string_view name,
                         const BlockConfig& config,
                         const Shape& shape,
                         HierarchicalDepth* coarse)
    : config_(config)
    , shape_(shape)
    , grain_(shape.line_bytes)
    , coarse_(coarse)
    , contents_(shape.line_bytes)
    , statistics_(name) {}

// --- Look-up -----------------------------------------------------------------------------------

BlockStates::Target* BlockStates::target_of(std::uint64_t number) {
    auto after = targets_.upper_bound(number);
    if (after == targets_.begin()) return nullptr;
    Target& target = (--after)->second;
    return number - target.first_line < target.blocks.size() ? &target : nullptr;
}

BlockStates::Block* BlockStates::find(std::uint64_t number) {
    Target* const target = target_of(number);
    return target ? &target->blocks[number - target->first_line] : nullptr;
}

const BlockStates::Block* BlockStates::find(std::uint64_t number) const {
    return const_cast<BlockStates*>(this)->find(number);
}

BlockState BlockStates::state(std::uint64_t number) const {
    const Block* const block = find(number);
    return block ? block->state : BlockState::Plain;
}

void BlockStates::set_state(Target& target, Block& block, BlockState state) {
    target.cleared += state == BlockState::Cleared;
    target.cleared -= block.state == BlockState::Cleared;
    block.state = state;
}

// --- Lines -------------------------------------------------------------------------------------

std::uint32_t BlockStates::stored_bytes(std::uint64_t number) const {
    const Block* const block = find(number);
    if (!block || block->state == BlockState::Plain) return shape_.line_bytes;
    return block->state == BlockState::Cleared ? 0 : block->bytes;
}

void BlockStates::fetched(std::uint64_t number, work::LineMask dirty) {
    const std::uint32_t saved = shape_.line_bytes - stored_bytes(number);
    if (state(number) == BlockState::Cleared) {
        check_cleared(*target_of(number), number, dirty);
        ++statistics_.cleared_reads;
        statistics_.cleared_read_bytes += saved;
    } else if (state(number) == BlockState::Compressed) {
        ++statistics_.compressed_reads;
        statistics_.compressed_read_bytes += saved;
    }
}

// What the cache did not change is of the clear value. What lies beyond the target's edge matters
// to nobody.
void BlockStates::check_cleared(const Target& target,
                                std::uint64_t number,
                                work::LineMask dirty) const {
    const auto content = contents_.line(number);
    const std::size_t bytes = format_info(target.format).block_bytes;
    std::size_t other = 0;
    for (std::size_t at = 0; at < content.size(); at += bytes)
        if ((dirty & grain_.touched(static_cast<std::uint32_t>(at),
                                    static_cast<std::uint32_t>(at + bytes))) == 0)
            other += std::memcmp(&content[at], &target.clear_word, bytes) != 0;
    if (other == 0) return;
    const work::ImageLayout& layout = target.place.layout;
    const bool padded = layout.kind != work::Layout::Linear &&
                        (layout.width % layout.block != 0 || layout.height % layout.block != 0);
    check(padded || (number + 1) * shape_.line_bytes > target.place.base + target.place.layer_bytes,
          "a cleared block is of the clear value");
}

std::uint32_t BlockStates::code_bytes(std::uint64_t number) const {
    const auto content = contents_.line(number);
    const work::BlockShape shape = contents_.shape(number);
    if (shape.bytes() != content.size()) return shape_.line_bytes; // A pixel lies on two lines.
    const std::vector<std::uint8_t> code = work::encode_block(shape, content);
    const auto bursts =
        static_cast<std::uint32_t>((code.size() + shape_.burst_bytes - 1) / shape_.burst_bytes);
    if (bursts * shape_.burst_bytes >= shape_.line_bytes) return shape_.line_bytes;
    std::vector<std::byte> decoded(content.size());
    work::decode_block(shape, code, decoded);
    check(std::equal(decoded.begin(), decoded.end(), content.begin()),
          "a block's code decodes to the block");
    return bursts * shape_.burst_bytes;
}

LineWrite BlockStates::write_back(const LeavingLine& line) {
    const std::uint32_t dirty = grain_.moved_bytes(line.dirty, shape_.transfer_bytes);
    LineWrite out{.number = line.number, .bytes = dirty};
    if (coarse_ && !contents_.line(line.number).empty())
        coarse_->leave(line.number, contents_.shape(line.number), contents_.line(line.number));
    Target* const target = target_of(line.number);
    if (!target) return out;
    Block& block = target->blocks[line.number - target->first_line];
    const bool complete = line.valid == grain_.all();
    const bool plain = block.state == BlockState::Plain;
    if (plain && (!complete || !config_.compression)) {
        ++statistics_.plain_writes;
        return out;
    }
    if (!complete && block.state == BlockState::Compressed) {
        out.read_bytes = block.bytes;
        statistics_.merge_read_bytes += block.bytes;
    }
    const std::uint32_t bytes = config_.compression ? code_bytes(line.number) : shape_.line_bytes;
    const bool compressed = bytes < shape_.line_bytes;
    if (compressed || !plain) out.bytes = bytes;
    block.bytes = bytes;
    set_state(*target, block, compressed ? BlockState::Compressed : BlockState::Plain);
    ++(compressed ? statistics_.compressed_writes : statistics_.plain_writes);
    statistics_.saved_write_bytes += dirty > out.bytes ? dirty - out.bytes : 0;
    statistics_.completed_write_bytes += out.bytes > dirty ? out.bytes - dirty : 0;
    return out;
}

void BlockStates::write(const work::PlacedLevel& place,
                        const work::PreparedQuad& quad,
                        const SampleWords& values,
                        std::uint64_t number,
                        bool stencil) {
    contents_.write(place, quad, values, number);
    if (!stencil) return;
    if (Block* const block = find(number)) block->stencil_cleared = false;
}

// --- Contents ----------------------------------------------------------------------------------

void BlockStates::content(const work::PreparedContent& content) {
    const bool is_new = targets_.find(content.place.base / shape_.line_bytes) == targets_.end();
    contents_.set(content.place, *content.content, [&](std::uint64_t number) { forget(number); });
    if (is_new) add_target(content);
}

// The driver cleared the stencil values when it gave the target its memory, and says so where the
// program has not changed them since.
void BlockStates::add_target(const work::PreparedContent& content) {
    Target target;
    target.place = content.place;
    target.format = content.content->surface.format;
    target.first_line = content.place.base / shape_.line_bytes;
    const std::uint64_t lines =
        (content.place.layer_bytes + shape_.line_bytes - 1) / shape_.line_bytes;
    const std::uint64_t room =
        config_.on_chip == 0 ? lines
                             : config_.on_chip - std::min<std::uint64_t>(kept_, config_.on_chip);
    target.blocks.resize(config_.is_on() ? std::min(lines, room) : 0);
    kept_ += target.blocks.size();
    if (target.format == Format::Depth24Stencil8) {
        const auto& bytes = content.content->bytes;
        bool alike = true;
        for (std::size_t i = 0; i < bytes.size(); i += 4)
            alike = alike && bytes[i] == bytes[0];
        target.clear_word = std::to_integer<std::uint32_t>(bytes[0]);
        for (Block& block : target.blocks)
            block.stencil_cleared = alike;
    }
    if (coarse_) coarse_->add(target.place, target.format);
    targets_[target.first_line] = std::move(target);
}

void BlockStates::forget(std::uint64_t number) {
    if (coarse_) coarse_->forget(number);
    Target* const target = target_of(number);
    if (!target) return;
    Block& block = target->blocks[number - target->first_line];
    set_state(*target, block, BlockState::Plain);
    block.stencil_cleared = false;
}

bool BlockStates::make_plain(std::uint64_t number, Change change) {
    Target* const target = target_of(number);
    if (!target) return false;
    Block& block = target->blocks[number - target->first_line];
    const bool was_plain = block.state == BlockState::Plain;
    set_state(*target, block, BlockState::Plain);
    if (was_plain || change == Change::Whole) return false;
    ++statistics_.resolved;
    return true;
}

// --- Clears ------------------------------------------------------------------------------------

void BlockStates::begin_clear(const work::PreparedTransfer& transfer) {
    for (const work::SurfaceFill& fill : transfer.fills) {
        const auto found = targets_.find(fill.place.base / shape_.line_bytes);
        if (found != targets_.end()) plan_clear(transfer, fill, found->second);
    }
}

bool BlockStates::takes_state(const Target& target, const work::TransferLine& line) {
    const Block* const block = find(line.line.number);
    return block && line.whole && (!target.keeps_stencil || block->stencil_cleared);
}

// A target has one clear value: another one is taken where no block stays cleared to the old.
void BlockStates::plan_clear(const work::PreparedTransfer& transfer,
                             const work::SurfaceFill& fill,
                             Target& target) {
    const std::uint32_t all = pixel_mask(target.format), mask = fill.mask & all;
    const bool stencil = target.format == Format::Depth24Stencil8;
    target.writes_stencil = stencil && (mask & StencilMask) != 0;
    target.keeps_stencil = stencil && mask == DepthMask;
    target.fast = config_.fast_clear && is_constant(fill) && (mask == all || target.keeps_stencil);
    if (!target.fast) return;
    const std::uint32_t word =
        (fill.value_at(0, 0) & mask) | (target.keeps_stencil ? target.clear_word & StencilMask : 0);
    std::uint64_t again = 0;
    for (const work::TransferLine& line : transfer.lines)
        if (target_of(line.line.number) == &target && takes_state(target, line))
            again += state(line.line.number) == BlockState::Cleared;
    target.fast = word == target.clear_word || again == target.cleared;
    if (!target.fast) return;
    if (stencil && (word & StencilMask) != (target.clear_word & StencilMask))
        for (Block& block : target.blocks)
            block.stencil_cleared = false;
    target.clear_word = word;
}

bool BlockStates::clear_fast(const work::TransferLine& line) {
    Target* const target = target_of(line.line.number);
    if (!target) return false;
    Block& block = target->blocks[line.line.number - target->first_line];
    if (!target->fast || !takes_state(*target, line)) {
        if (target->writes_stencil) block.stencil_cleared = false;
        ++statistics_.cleared_slowly;
        return false;
    }
    set_state(*target, block, BlockState::Cleared);
    block.stencil_cleared = true;
    ++statistics_.cleared;
    return true;
}

void BlockStates::end_clear(const work::PreparedTransfer& transfer) {
    for (const work::SurfaceFill& fill : transfer.fills) {
        contents_.fill(fill);
        const auto found = targets_.find(fill.place.base / shape_.line_bytes);
        if (found == targets_.end() || !coarse_) continue;
        const Target& target = found->second;
        if ((fill.mask & pixel_mask(target.format) & ~StencilMask) == 0) continue;
        const std::uint32_t depth = depth_of(target.format, fill.value);
        const std::uint64_t lines =
            (target.place.layer_bytes + shape_.line_bytes - 1) / shape_.line_bytes;
        for (const work::TransferLine& line : transfer.lines) {
            const std::uint64_t number = line.line.number;
            if (!line.depth || number - target.first_line >= lines) continue;
            line.whole ? coarse_->set(number, {depth, depth}) : coarse_->widen(number, depth);
        }
    }
}

} // namespace ffgpu::timing
