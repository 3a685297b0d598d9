// WorkFileWriter: keeps whole commands in a file, streamed: it holds a block at most.

#pragma once

#include "model/base/chunk_memory.h"
#include "model/base/whole_file.h"
#include "model/work/column_bytes.h"
#include "model/work/frame_figures.h"
#include "model/work/quad_columns.h"
#include "model/work/whole_command.h"
#include "model/work/work_fields.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

struct ZSTD_CCtx_s;

namespace ffgpu::work {

using ZSTD_CCtx = ZSTD_CCtx_s; // zstd.h

class WorkFileWriter final : public CommandSink {
public:
    // Throws InputError, as all below, where the file cannot be written.
    explicit WorkFileWriter(const std::string& path);
    ~WorkFileWriter() override;

    void command(std::shared_ptr<const WholeCommand> command) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override;
    void host_transfer(const HostTransfer& transfer) override;
    void end_frame(std::uint32_t frame) override;
    // The frame's work is all written.
    void frame(const FrameFigures& figures);

    // Without it there is no file.
    void finish();

private:
    void begin_item(Item item);
    void write_names();
    void write_state(const std::shared_ptr<const Registers>& state);
    void write_geometry(const GeometryWork& geometry);
    void write_primitives(const GeometryWork& geometry);
    void write_assembly(std::span<const PrimitiveWork> primitives, PrimitiveWork before);
    void write_pieces(std::span<const PieceBox> pieces);
    std::size_t items_of_block(std::size_t left, std::size_t most_bytes) const;
    void write_quads(const WholeCommand& command);
    std::size_t quads_of_block(const WholeCommand& command, std::size_t first) const;
    void write_block(BlockKind kind);
    template <class Command>
    void write_fields(const Command& command);

    struct FreeContext {
        void operator()(ZSTD_CCtx* context) const;
    };

    WholeFile file_;
    std::unique_ptr<ZSTD_CCtx, FreeContext> context_;
    UnsetVector<std::uint8_t> raw_, packed_; // of the block that is written
    bool finished_ = false;
    ColumnWriter columns_;
    std::uint32_t items_ = 0;
    std::shared_ptr<const Registers> state_; // the last written
    FieldValues state_values_, values_;
    PieceBox box_; // the last written
    QuadColumnWriter quads_out_;
};

} // namespace ffgpu::work
