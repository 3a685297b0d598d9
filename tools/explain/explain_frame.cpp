#include "tools/explain/explain_frame.h"

#include "model/base/check.h"
#include "model/memory/pixel_format.h"
#include "tools/explain/explained_timing.h"
#include "tools/explain/history_collector.h"
#include "tools/explain/pixel_changes.h"
#include "tools/record/work_fan_out.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

namespace ffgpu::tools {
namespace {

PixelValue read_color(FunctionalGpu& gpu, const SurfacePixel& pixel) {
    PixelValue value;
    value.samples = pixel.surface.samples;
    std::array<std::byte, 4> bytes{};
    const std::size_t size = format_info(pixel.surface.format).block_bytes;
    for (unsigned i = 0; i < value.samples; ++i) {
        const std::uint64_t at = pixel.address() + i * pixel.surface.plane_bytes();
        gpu.read_memory(static_cast<DeviceAddress>(at), std::span(bytes).first(size));
        value.color[i] = load_rgba8(pixel.surface.format, bytes.data());
    }
    return value;
}

// Depth, and stencil where there is one.
void read_depth(FunctionalGpu& gpu, const SurfacePixel& pixel, PixelEvent& event) {
    std::array<std::byte, 4> bytes{};
    const bool has_stencil = pixel.surface.format == Format::Depth24Stencil8;
    gpu.read_memory(static_cast<DeviceAddress>(pixel.address()),
                    std::span(bytes).first(format_info(pixel.surface.format).block_bytes));
    const auto word = load_word<std::uint32_t>(bytes.data());
    event.depth_after = has_stencil ? word >> 8 : word;
    if (has_stencil) event.stencil_after = word & 0xff;
}

// Clears and copies come in the order of the steps; of a draw fragments come batch by batch.
void sort_events(PixelHistory& history) {
    std::ranges::stable_sort(history.events, [](const PixelEvent& a, const PixelEvent& b) {
        return std::tie(a.step, a.primitive, a.piece) < std::tie(b.step, b.primitive, b.piece);
    });
}

class FrameExplainer {
public:
    explicit FrameExplainer(const FrameQuestion& question)
        : question_(question)
        , tape_(question.tape)
        , gpu_({.stages = &ReferenceStages}) {
        tape_.prepare(gpu_);
        place_pixels();
        collector_ = std::make_unique<HistoryCollector>(histories_);
        gpu_.set_stage_probe(collector_.get());
        if (question.timing) {
            timing_ = std::make_unique<ExplainedTiming>(*question.timing, *collector_);
            sinks_.add(timing_->sink());
        }
        if (question.work) sinks_.add(*question.work);
        const bool values = question.timing && !question.timing->needs_values().empty();
        if (!sinks_.empty())
            gpu_.set_work_sink(&sinks_, values ? WorkDetail::Values : WorkDetail::Masks);
    }

    std::vector<PixelHistory> run() {
        std::uint32_t draw = tape_.first_draw;
        for (std::size_t i = 0; i < tape_.steps.size(); ++i) {
            const TapeStep& step = tape_.steps[i];
            const bool is_command = step.kind == TapeStep::Kind::Command;
            if (is_command && is_numbered(step.opcode())) collector_->begin_draw(draw++, i, step);
            play(i, step);
        }
        settle();
        gpu_.set_stage_probe(nullptr);
        gpu_.set_work_sink(nullptr);
        for (PixelHistory& history : histories_)
            finish(history);
        return std::move(histories_);
    }

private:
    struct Change {
        HistoryCollector::Watch* watch;
        PixelEvent event;
    };

    void place_pixels() {
        const PixelSources sources(tape_);
        for (std::size_t i = 0; i < question_.pixels.size(); ++i) {
            const auto [x, y] = question_.pixels[i];
            PixelHistory& history = histories_.emplace_back();
            history.frame = tape_.frame;
            history.x = x;
            history.y = y;
            history.value = question_.values[i];
            history.places =
                sources.places({question_.picture, x, question_.picture.height - 1u - y});
            for (const PixelPlace& place : history.places)
                history.before.push_back(read_color(gpu_, place.color));
        }
    }

    // All that was submitted is drawn and told.
    void settle() {
        gpu_.finish();
        collector_->end_batch();
    }

    void play(std::size_t number, const TapeStep& step) {
        std::vector<Change> changes = find_changes(number, step);
        if (!changes.empty()) settle();
        FrameTape::play(step, gpu_);
        if (changes.empty()) return;
        gpu_.hide_from_work(true); // Looking is no work of the machine's.
        for (Change& change : changes)
            add(*change.watch, std::move(change.event));
        gpu_.hide_from_work(false);
    }

    std::vector<Change> find_changes(std::size_t number, const TapeStep& step) {
        std::vector<Change> changes;
        for (HistoryCollector::Watch& watch : collector_->watches()) {
            const PixelPlace& place = histories_[watch.history].places[watch.place];
            if (number >= place.until) continue;
            auto event = change_of(step, gpu_.registers(), place);
            if (!event) continue;
            event->step = number;
            event->place = watch.place;
            event->call = step.call;
            changes.push_back({&watch, std::move(*event)});
        }
        return changes;
    }

    void add(HistoryCollector::Watch& watch, PixelEvent event) {
        PixelHistory& history = histories_[watch.history];
        const PixelPlace& place = history.places[watch.place];
        watch.value = event.after = read_color(gpu_, place.color);
        const bool may_touch_depth =
            event.kind == PixelEvent::Kind::Clear || event.kind == PixelEvent::Kind::StencilImage;
        if (may_touch_depth && !place.depths.empty()) read_depth(gpu_, place.depths[0], event);
        history.events.push_back(std::move(event));
    }

    void finish(PixelHistory& history) {
        sort_events(history);
        PixelValue last = history.before[0];
        std::vector<PixelValue> at_places = history.before;
        for (PixelEvent& event : history.events) {
            // A primitive that made no fragment left what was there.
            if (event.is_of_draw() && !event.fragment) event.after = at_places[event.place];
            at_places[event.place] = event.after;
            if (event.place == 0) last = event.after;
        }
        check(last.color[0] == history.value,
              "the last value of a pixel's history is not the frame's");
        check(read_color(gpu_, history.places[0].color) == last,
              "a pixel changed behind its history");
        if (timing_) history.cycles = timing_->cycles();
    }

    const FrameQuestion& question_;
    const FrameTape& tape_;
    FunctionalGpu gpu_;
    std::vector<PixelHistory> histories_;
    std::unique_ptr<HistoryCollector> collector_;
    std::unique_ptr<ExplainedTiming> timing_;
    WorkFanOut sinks_;
};

} // namespace

std::vector<PixelHistory> explain_frame(const FrameQuestion& question) {
    return FrameExplainer(question).run();
}

} // namespace ffgpu::tools
