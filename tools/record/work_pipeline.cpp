#include "tools/record/work_pipeline.h"

#include <utility>
#include <vector>

namespace ffgpu::tools {

WorkPipeline::WorkPipeline(const Options& options, StatisticsReport& report)
    : table_(options.draw_table.empty()
                 ? nullptr
                 : std::make_unique<DrawTable>(options.draw_table, *options.draw_notes))
    , timing_(options.timing ? std::make_unique<timing::GpuTiming>(*options.timing) : nullptr)
    , file_(options.save_work.empty() ? nullptr
                                      : std::make_unique<work::WorkFileWriter>(options.save_work))
    , draw_pixels_(options.draw_pixels.empty() ? nullptr
                                               : std::make_unique<DrawPixels>(options.draw_pixels))
    , costs_(options.timing ? options.costs : nullptr)
    , on_frame_(options.on_frame)
    , meter_(report, timing_.get())
    , assembler_(readers_) {
    if (timing_ && options.timing->series.interval_cycles > 0) series_.emplace(*timing_);
    if (timing_) readers_.add(*timing_);
    if (file_) readers_.add(*file_);
    if (table_) readers_.add(*table_);
    if (table_ && timing_) timing_->set_quad_observer(table_.get());
    if (draw_pixels_) readers_.add(*draw_pixels_);
    if (timing_ && options.costs)
        timing_->set_on_retire([costs = options.costs](const timing::QuadRetired& quad) {
            costs->quad_retired(quad);
        });
    if (timing_ || file_ || table_ || draw_pixels_) thread_.emplace(assembler_);
}

void WorkPipeline::frame(const work::FrameFigures& figures, const Surface& shown) {
    if (!thread_) return add(figures, shown);
    thread_->check_failure();
    thread_->post([this, figures, shown] { add(figures, shown); });
}

void WorkPipeline::add(const work::FrameFigures& figures, const Surface& shown) {
    has_frame_ = true;
    if (file_) file_->frame(figures);
    if (draw_pixels_) draw_pixels_->frame(figures.number, shown);
    std::vector<DrawTable::Row> rows;
    if (table_) rows = table_->take_rows();
    meter_.add(
        figures,
        [this, number = figures.number, rows = std::move(rows)](const timing::FrameTiming* timed) {
            if (costs_ && timed) costs_->frame_waited(timed->waited);
            if (table_) table_->write(number, rows, timed);
            on_frame_(timed ? timed->cycles : 0);
        });
}

void WorkPipeline::drain() {
    try {
        if (thread_) thread_->drain();
    } catch (...) {
        if (timing_) timing_->catch_up();
        throw;
    }
    if (timing_) timing_->catch_up();
}

HeatPlane WorkPipeline::block_bytes(const Surface& shown, bool depth) const {
    HeatPlane plane{shown.width, shown.height, {}};
    plane.values.resize(std::size_t{plane.width} * plane.height);
    if (!timing_) return plane;
    const std::vector<std::uint32_t> bytes = timing_->block_bytes(shown, depth);
    for (std::size_t i = 0; i < bytes.size(); ++i) { // The lowest row is the first of them.
        const std::size_t x = i % plane.width, row = plane.height - 1 - i / plane.width;
        plane.values[row * plane.width + x] = static_cast<float>(bytes[i]);
    }
    return plane;
}

void WorkPipeline::write_series(const std::string& folder) const {
    if (series_) series_->write(folder);
}

void WorkPipeline::finish() {
    drain();
    if (file_ && has_frame_) file_->finish(); // One without a frame is not kept.
    if (table_) table_->finish();
    if (draw_pixels_) draw_pixels_->finish();
}

} // namespace ffgpu::tools
