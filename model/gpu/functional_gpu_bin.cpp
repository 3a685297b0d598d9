// FunctionalGpu: draws on their way into the bin, and bins carried out.

#include "model/base/float_environment.h"
#include "model/device/extents.h"
#include "model/device/validate.h"
#include "model/gpu/functional_gpu.h"
#include "model/gpu/piece_work.h"

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

// Twice what a primitive would cover, about: exact for triangles inside the clip rectangle.
double double_area_of(const SetupRecord& record) {
    constexpr double Pixel = 2 << 2 * SubPixelBits;
    if (record.edge_count != 3) return Pixel * record.box.width() * record.box.height();
    const Edge& first = record.edges[0];
    const Edge& last = record.edges[2];
    return static_cast<double>(std::int64_t{first.b} * last.a - std::int64_t{last.b} * first.a);
}

// Triangles at the beginning, as many as a group takes.
std::size_t leading_triangles(std::span<const Primitive> batch) {
    std::size_t count = 0;
    while (count < std::min<std::size_t>(batch.size(), TriangleGroup::Size) &&
           batch[count].shape == PrimitiveShape::Triangle)
        ++count;
    return count;
}

constexpr std::uint64_t MostRecordedArea = 1 << 18; // of a bin, in pixels

PieceBox piece_box(const Rectangle& box) {
    const auto narrow = [](int at) { return static_cast<std::uint16_t>(at); };
    return {narrow(box.x0), narrow(box.y0), narrow(box.x1), narrow(box.y1)};
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
    ++primitive_statistics_.draws;
    before_read(command.vertex_address, vertex_bytes(command, registers_.values().vertex_format));
    if (command.index_type != IndexType::None)
        before_read(command.index_address, index_bytes(command));
    const std::uint32_t number = draw_number_++;
    if (command.output == DrawOutput::Feedback) {
        before_write(command.feedback_address, command.feedback_bytes);
        geometry_.feedback(context_->state, command, memory_.bytes());
        return;
    }
    const bool own_target = reads_own_target(*context_);
    if (own_target) flush();
    begin_command({.kind = WorkKind::Draw, .number = number});
    bin_serial_ = bin_serial_ || own_target;
    samples_pending_ = samples_pending_ || context_->pixels->count_samples;

    last_key_ = next_piece_ = 0;
    draw_in_geometry(command);
    if (own_target) flush();
}

// What becomes of the draw before pixels is told where it ends, in the last bin that it reached.
void FunctionalGpu::draw_in_geometry(const DrawCommand& command) {
    if (!sink_) return geometry_.draw(context_->state, command, *this);
    const auto [writes, words] = std::exchange(registers_sent_, {});
    geometry_work_ = {};
    geometry_.draw(context_->state, command, *this, &geometry_work_);
    BinCommand& last = bin_.commands().back();
    last.geometry = std::exchange(geometry_work_, {});
    last.register_writes = writes;
    last.register_words = words;
}

// Undefined in OpenGL, but it is to repeat, whatever the number of threads.
bool FunctionalGpu::reads_own_target(const DrawContext& context) const {
    bool overlaps = false;
    for_each_image(context, [&](const TextureImage& image) {
        const std::uint64_t begin = image.address, end = begin + texture_bytes(image.shape);
        for_each_target(context.regs().targets, [&](const Surface& surface) {
            overlaps =
                overlaps || (begin < surface.address + surface.bytes() && surface.address < end);
        });
    });
    return overlaps;
}

// Makes `command` the one that is binned from now on, in the state of context_.
void FunctionalGpu::begin_command(BinCommand command) {
    const Targets& targets = context_->regs().targets;
    if (!bin_.empty() && (bin_is_full() || !(bin_targets_ == targets))) carry_out();
    if (context_->pixels != binned_pixels_) {
        // Textures that the bin draws into must be finished; others must stay as they are.
        for_each_image(*context_, [this](const TextureImage& image) {
            before_read(image.address, texture_bytes(image.shape));
        });
    }
    if (bin_.empty()) open_bin(targets);
    if (context_->pixels != binned_pixels_) {
        for_each_image(*context_, [this](const TextureImage& image) {
            bin_reads_.add(image.address, texture_bytes(image.shape));
        });
        binned_pixels_ = context_->pixels;
    }
    command.frame = frame_;
    command.pixels = context_->pixels;
    // Registers are large: those of draws that are only drawn go as soon as geometry has read them.
    if (command.kind != WorkKind::Draw || sink_ || probe_) command.context = context_;
    if (command.kind != WorkKind::Draw) {
        const auto [writes, words] = std::exchange(registers_sent_, {});
        command.register_writes = writes;
        command.register_words = words;
    }
    bin_.add_command(std::move(command));
}

void FunctionalGpu::open_bin(const Targets& targets) {
    int width = 0, height = 0;
    for_each_target(targets, [&](const Surface& surface) {
        bin_writes_.add(surface.address, surface.bytes());
        width = std::max<int>(width, surface.width);
        height = std::max<int>(height, surface.height);
    });
    bin_targets_ = targets;
    bin_.reset(width, height);
    if (config_.stages->remembers_clears)
        bin_.set_cleared(cleared_.of(targets, bin_.tile_size(), bin_.tile_count()));
    if (records_values()) tell_contents(targets);
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

void FunctionalGpu::primitives(std::span<const Primitive> batch) {
    constexpr std::size_t Few = 2; // A group takes its time, however many there are.
    const bool in_groups = !probe_ && goes_in_groups(context_->setup);
    while (!batch.empty()) {
        const std::size_t triangles = in_groups ? leading_triangles(batch) : 0;
        if (triangles > Few) {
            bin_triangles(batch.first(triangles));
            batch = batch.subspan(triangles);
        } else {
            bin_primitive(batch.front());
            batch = batch.subspan(1);
        }
    }
}

void FunctionalGpu::bin_triangles(std::span<const Primitive> triangles) {
    config_.stages->set_up_triangles(context_->setup, triangles, *group_);
    for (unsigned i = 0; i < triangles.size(); ++i)
        bin_triangle(triangles[i], i);
}

// That at `place` of the group.
void FunctionalGpu::bin_triangle(const Primitive& triangle, unsigned place) {
    const TriangleGroup& group = *group_;
    const auto is = [place](TriangleGroup::Bits bits) { return (bits >> place & 1) != 0; };
    if (is(group.alone)) return bin_primitive(triangle);
    SetupRecord& record = begin_record(triangle);
    if (is(group.empty)) return count_empty();
    count_area(group.box[place], group.double_area[place]);
    if (is(group.nothing)) return;
    write_record(context_->setup, group, place, triangle, record);
    tell_set_up(record);
    bin_.insert();
}

// Room for the record of the primitive that is next, with its piece's number.
SetupRecord& FunctionalGpu::begin_record(const Primitive& primitive) {
    if (bin_is_full()) {
        // The draw goes on in the next bin, under the same number.
        const std::uint32_t number = bin_.commands().back().number;
        const bool serial = bin_serial_;
        draw_goes_on_ = true;
        carry_out();
        draw_goes_on_ = false;
        begin_command({.kind = WorkKind::Draw, .number = number});
        bin_serial_ = serial;
    }
    ++primitive_statistics_.primitives;
    if (primitive.key != last_key_) next_piece_ = 0;
    last_key_ = primitive.key;
    SetupRecord& record = bin_.next_record();
    record.piece = next_piece_++;
    return record;
}

void FunctionalGpu::bin_primitive(const Primitive& primitive) {
    SetupRecord& record = begin_record(primitive);
    const bool covers = set_up(context_->setup, primitive, record, probe_ != nullptr);
    if (probe_)
        probe_->set_up({.draw = bin_.commands().back().number,
                        .frame = frame_,
                        .registers = &context_->regs(),
                        .primitive = &primitive,
                        .record = covers ? &record : nullptr});
    if (!covers) return count_empty();
    count_area(record.box, double_area_of(record));
    if (record.covers_nothing) return;
    tell_set_up(record);
    bin_.insert();
}

// Of the piece that was counted last.
void FunctionalGpu::tell_set_up(const SetupRecord& record) {
    if (sink_) add_set_up(context_->setup.layout, record, geometry_work_.pieces.back());
}

void FunctionalGpu::count_empty() {
    ++primitive_statistics_.empty;
    if (sink_) geometry_work_.pieces.push_back({});
}

// double_area: in square sub-pixels, twice.
void FunctionalGpu::count_area(const Rectangle& box, double double_area) {
    constexpr double PerPixel = 1.0 / (2 << 2 * SubPixelBits);
    primitive_statistics_.add_area(double_area * PerPixel);
    if (!sink_) return;
    geometry_work_.pieces.push_back(piece_box(box));
    const auto pixels = std::uint64_t(box.width()) * std::uint64_t(box.height());
    bin_area_ += std::min(pixels, static_cast<std::uint64_t>(double_area * PerPixel) + 1);
}

// What a recorded bin tells waits for others to read it, some 80 bytes a quad.
bool FunctionalGpu::bin_is_full() const {
    return bin_.full() || (sink_ && bin_area_ >= MostRecordedArea);
}

void FunctionalGpu::before_read(std::uint64_t at, std::uint64_t bytes) {
    if (bin_writes_.overlaps(at, bytes)) flush();
    if (under_way_.writes_to(at, bytes)) finish_carrying();
}

void FunctionalGpu::before_write(std::uint64_t at, std::uint64_t bytes) {
    forget_contents(at, bytes);
    if (bin_writes_.overlaps(at, bytes) || bin_reads_.overlaps(at, bytes)) flush();
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
    transfers_.push_back({.before_draw = static_cast<std::uint32_t>(bin_.commands().size()),
                          .is_write = is_write,
                          .at = static_cast<DeviceAddress>(at),
                          .bytes = bytes});
}

void FunctionalGpu::flush() {
    if (!bin_.empty())
        carry_out();
    else if (sink_ && !transfers_.empty())
        hand_over({}, {});
    finish_carrying();
}

// Bins are drawn one after another: what draws see of each other does not depend on threads.
void FunctionalGpu::carry_out() {
    const FloatEnvironment environment;
    finish_carrying();
    if (bin_serial_ || probe_ || sink_) {
        draw_and_record();
        bin_.reset(0, 0);
    } else {
        std::swap(bin_, under_way_.bin);
        std::swap(bin_reads_, under_way_.reads);
        std::swap(bin_writes_, under_way_.writes);
        under_way_.busy = true;
        Bin& bin = under_way_.bin;
        const std::vector<std::uint32_t>& tiles = bin.busy_tiles();
        pool_.start(tiles.size(), [this, &bin, &tiles](unsigned worker, std::size_t i) {
            renderers_[worker]->render(bin, tiles[i], {});
        });
        if (pool_.done()) finish_carrying();
    }
    ++host_statistics_.bins;
    bin_area_ = 0;
    bin_reads_.clear();
    bin_writes_.clear();
    binned_pixels_.reset();
    bin_serial_ = false;
}

void FunctionalGpu::finish_carrying() {
    if (under_way_.busy) {
        const FloatEnvironment environment;
        pool_.wait();
        under_way_.busy = false;
        under_way_.bin.reset(0, 0);
        under_way_.reads.clear();
        under_way_.writes.clear();
    }
    for (const auto& renderer : renderers_) {
        const FragmentCounts counts = renderer->take_counts();
        fragment_statistics_.add(counts);
        host_statistics_.add(counts);
        samples_ += counts.counted_samples;
    }
    if (bin_.empty()) samples_pending_ = false;
}

} // namespace ffgpu
