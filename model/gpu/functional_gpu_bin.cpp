// FunctionalGpu: draws on their way into the bin, and bins carried out.

#include "model/base/float_environment.h"
#include "model/device/extents.h"
#include "model/device/validate.h"
#include "model/gpu/functional_gpu.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ffgpu {
namespace {

template <class Visit>
void for_each_target(const Targets& targets, Visit&& visit) {
    Targets::for_each(targets, [&](const Surface& surface) {
        if (surface.format != Format::None) visit(surface);
    });
}

template <class Visit>
void for_each_image(const DrawContext& context, Visit&& visit) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (context.pixels->samples(unit) && context.pixels->textures[unit].valid)
            visit(context.regs().images[unit]);
}

SurfaceContent content_of(const Surface& surface, std::span<const std::byte> memory) {
    SurfaceContent content;
    content.surface = surface;
    const std::uint32_t row = row_bytes(surface.format, surface.width);
    content.bytes.resize(std::size_t{row} * surface.height * surface.samples);
    std::byte* to = content.bytes.data();
    for (unsigned sample = 0; sample < surface.samples; ++sample)
        for (std::uint32_t y = 0; y < surface.height; ++y, to += row)
            std::memcpy(to,
                        memory.data() + surface.address + sample * surface.plane_bytes() +
                            std::uint64_t{y} * surface.stride,
                        row);
    return content;
}

} // namespace

void FunctionalGpu::prepare_context() {
    if (context_valid_) return;
    validate(registers_.values(), memory_.size());
    context_ = compile_draw_context(registers_.snapshot(),
                                    draw_number_,
                                    pixel_contexts_,
                                    pixels_valid_ ? context_.get() : nullptr);
    context_valid_ = pixels_valid_ = true;
}

void FunctionalGpu::draw(const DrawCommand& command) {
    validate(command, registers_.values(), memory_.size());
    prepare_context();
    ++primitive_statistics().draws;
    before_read(command.vertex_address, vertex_bytes(command, registers_.values().vertex_format));
    if (command.index_type != IndexType::None)
        before_read(command.index_address, index_bytes(command));
    const std::uint32_t number = draw_number_++;
    if (command.output == DrawOutput::Feedback) {
        before_write(command.feedback_address, command.feedback_bytes);
        geometry().feedback(context_->state, command, memory_.bytes());
        return;
    }
    const bool own_target = reads_own_target(*context_, command);
    if (own_target) flush();
    begin_command({.kind = WorkKind::Draw, .number = number});
    bin_serial_ = bin_serial_ || own_target;

    if (!bin_serial_ && !sink_ && !probe_ && pool_.threads() > 1) {
        const std::uint32_t chunks = geometry().separate_chunks(context_->state, command);
        if (chunks > 1 && pool_.shares()) return draw_in_chunks(command, number, chunks);
    }
    draw_in_geometry(command);
    if (own_target) flush();
}

// What becomes of the draw before pixels is told where it ends, in the last bin that it reached.
void FunctionalGpu::draw_in_geometry(const DrawCommand& command) {
    GeometryWork* const work = sink_ ? &geometry_work_ : nullptr;
    if (work) *work = {};
    geometry_[0]->binner.start(*context_, bin(), *this, {.work = work, .probe = probe_});
    geometry().draw(context_->state, command, geometry_[0]->binner, work);
    if (!sink_) return;
    const auto [writes, words] = std::exchange(registers_sent_, {});
    BinCommand& last = bin().commands().back();
    last.geometry = std::exchange(geometry_work_, {});
    last.register_writes = writes;
    last.register_words = words;
}

// The draw goes on there, under the same number.
Bin& FunctionalGpu::next_bin() {
    const std::uint32_t number = bin().commands().back().number;
    const bool serial = bin_serial_;
    draw_goes_on_ = true;
    carry_out();
    draw_goes_on_ = false;
    begin_command({.kind = WorkKind::Draw, .number = number});
    bin_serial_ = serial;
    return bin();
}

// Textures, vertices or indices. Undefined in OpenGL, but it is to repeat, whatever the number of
// threads.
bool FunctionalGpu::reads_own_target(const DrawContext& context, const DrawCommand& command) const {
    bool overlaps = false;
    const auto look_at = [&](std::uint64_t begin, std::uint64_t bytes) {
        for_each_target(context.regs().targets, [&](const Surface& surface) {
            overlaps = overlaps || (begin < surface.address + surface.bytes() &&
                                    surface.address < begin + bytes);
        });
    };
    look_at(command.vertex_address, vertex_bytes(command, context.regs().vertex_format));
    look_at(command.index_address, index_bytes(command));
    for_each_image(context, [&](const TextureImage& image) {
        look_at(image.address, texture_bytes(image.shape));
    });
    return overlaps;
}

// Makes `command` the one that is binned from now on, in the state of context_.
void FunctionalGpu::begin_command(BinCommand command) {
    const Targets& targets = context_->regs().targets;
    if (!bins_.empty() && (bin().full() || !(bin_targets_ == targets))) carry_out();
    if (context_->pixels != binned_pixels_) {
        // Textures that the bin draws into must be finished; others must stay as they are.
        for_each_image(*context_, [this](const TextureImage& image) {
            const std::uint64_t bytes = texture_bytes(image.shape);
            context_->pixels->draws_colors ? before_read(image.address, bytes)
                                           : before_bin_reads(image.address, bytes);
        });
    }
    if (bins_.empty()) open_bin(targets);
    if (context_->pixels != binned_pixels_) {
        leave_undrawn(targets);
        for_each_image(*context_, [this](const TextureImage& image) {
            bins_.reads.add(image.address, texture_bytes(image.shape));
        });
        binned_pixels_ = context_->pixels;
    }
    samples_pending_ = samples_pending_ || context_->pixels->count_samples;
    command.frame = frame_;
    command.pixels = context_->pixels;
    // Registers are large: those of draws that are only drawn go as soon as geometry has read them.
    if (command.kind != WorkKind::Draw || sink_ || probe_) command.context = context_;
    if (command.kind != WorkKind::Draw) {
        const auto [writes, words] = std::exchange(registers_sent_, {});
        command.register_writes = writes;
        command.register_words = words;
    }
    bin().add_command(std::move(command));
}

void FunctionalGpu::open_bin(const Targets& targets) {
    for_each_target(targets, [&](const Surface& surface) {
        bins_.writes.add(surface.address, surface.bytes());
    });
    bin_targets_ = targets;
    Bin& bin = *bins_.bins.emplace_back(make_bin());
    if (config_.stages->remembers_clears)
        bin.set_cleared(cleared_.of(targets, bin.tile_size(), bin.tile_count()));
    if (records_values()) tell_contents(targets);
}

// For the targets of those at hand.
std::unique_ptr<Bin> FunctionalGpu::make_bin() {
    int width = 0, height = 0;
    for_each_target(bin_targets_, [&](const Surface& surface) {
        width = std::max<int>(width, surface.width);
        height = std::max<int>(height, surface.height);
    });
    std::unique_ptr<Bin> bin = stock_.take();
    bin->reset(width, height);
    return bin;
}

// Of targets that lie one in the other nothing is told.
void FunctionalGpu::tell_contents(const Targets& targets) {
    SurfaceJournal together;
    bool overlap = false;
    for_each_target(targets, [&](const Surface& surface) {
        overlap = overlap || together.touches(surface.address, surface.bytes());
        together.learn(surface);
    });
    for_each_target(targets, [&](const Surface& surface) {
        if (overlap) return journal_.forget(surface.address, surface.bytes());
        if (journal_.knows(surface)) return;
        journal_.learn(surface);
        contents_.push_back(
            std::make_shared<const SurfaceContent>(content_of(surface, memory_.bytes())));
    });
}

// Depths may lie where colours were left out, as memory is used again and copied.
void FunctionalGpu::leave_undrawn(const Targets& targets) {
    if (!context_->pixels->draws_colors)
        for (const Surface& color : targets.color)
            if (color.format != Format::None) undrawn_.add(color.address, color.bytes());
    const Surface& depth = targets.depth;
    if (depth.format != Format::None && undrawn_.overlaps(depth.address, depth.bytes()))
        missed_colors_ = true;
}

void FunctionalGpu::before_read(std::uint64_t at, std::uint64_t bytes) {
    before_bin_reads(at, bytes);
    missed_colors_ = missed_colors_ || undrawn_.overlaps(at, bytes);
}

void FunctionalGpu::before_bin_reads(std::uint64_t at, std::uint64_t bytes) {
    if (bins_.writes.overlaps(at, bytes)) flush();
    if (under_way_.writes_to(at, bytes)) finish_carrying();
}

void FunctionalGpu::before_write(std::uint64_t at, std::uint64_t bytes) {
    forget_contents(at, bytes);
    if (bins_.writes.overlaps(at, bytes) || bins_.reads.overlaps(at, bytes)) flush();
    if (under_way_.uses(at, bytes)) finish_carrying();
}

// Somebody else than a bin writes there.
void FunctionalGpu::forget_contents(std::uint64_t at, std::uint64_t bytes) {
    journal_.forget(at, bytes);
    cleared_.forget(at, bytes);
}

void FunctionalGpu::note_transfer(bool is_write, std::uint64_t at, std::uint64_t bytes) {
    constexpr std::size_t Most = 1 << 16;
    if (!sink_ || hidden_) return;
    if (transfers_.size() >= Most) flush();
    const std::size_t before = bins_.empty() ? 0 : bin().commands().size();
    transfers_.push_back({.before_draw = static_cast<std::uint32_t>(before),
                          .is_write = is_write,
                          .at = static_cast<DeviceAddress>(at),
                          .bytes = bytes});
}

void FunctionalGpu::flush() {
    if (!bins_.empty())
        carry_out();
    else if (sink_ && !transfers_.empty())
        hand_over({}, {});
    finish_carrying();
}

// Bins are drawn one after another: what draws see of each other does not depend on threads.
void FunctionalGpu::carry_out() {
    const FloatEnvironment environment;
    finish_carrying();
    const bool alone = bin_serial_ || probe_;
    put_under_way();
    if (alone || sink_) {
        draw_and_record(alone);
        return end_under_way();
    }
    pool_.start(under_way_tiles_.size(), [this](unsigned worker, std::size_t i) {
        renderers_[worker]->render(under_way_, under_way_tiles_[i], {});
    });
    if (pool_.done()) finish_carrying();
}

// The bins at hand; the next command opens others.
void FunctionalGpu::put_under_way() {
    std::swap(bins_, under_way_);
    under_way_.busy_tiles(under_way_tiles_);
    ++host_statistics_.bins;
    binned_pixels_.reset();
    bin_serial_ = false;
}

void FunctionalGpu::finish_carrying() {
    if (!under_way_.empty()) {
        const FloatEnvironment environment;
        pool_.wait();
    }
    end_under_way();
}

// They have been drawn.
void FunctionalGpu::end_under_way() {
    stock_.give_back(under_way_.bins);
    under_way_.reads.clear();
    under_way_.writes.clear();
    for (const auto& renderer : renderers_) {
        const FragmentCounts counts = renderer->take_counts();
        fragment_statistics_.add(counts);
        host_statistics_.add(counts);
        samples_ += counts.counted_samples;
    }
    if (bins_.empty()) samples_pending_ = false;
}

} // namespace ffgpu
