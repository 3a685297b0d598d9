#include "model/work/work_file_writer.h"

#include "model/base/check.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <zstd.h>

namespace ffgpu::work {
namespace {

constexpr int CompressionLevel = 1;

// What these take at most, in all columns.
constexpr std::size_t MostOfVertex = 5, MostOfPrimitive = 12, MostOfPiece = 2 * (3 + 10) + 4 * 5;

// As a column holds it, also where a box is none.
constexpr std::uint64_t number_of(int difference) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(difference));
}

} // namespace

WorkFileWriter::WorkFileWriter(const std::string& path)
    : file_(path)
    , context_(ZSTD_createCCtx()) {
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, CompressionLevel);
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
    file_.write(std::as_bytes(std::span(WorkFileMagic)));
    file_.write(std::as_bytes(std::span(&WorkFileVersion, 1)));
    field_values(Registers{}, state_values_);
    write_names();
}

WorkFileWriter::~WorkFileWriter() = default;

void WorkFileWriter::FreeContext::operator()(ZSTD_CCtx* context) const {
    ZSTD_freeCCtx(context);
}

// The lists of names by which a reader finds registers' and commands' fields.
void WorkFileWriter::write_names() {
    const auto list = [this](const std::vector<std::string>& names) {
        columns_.number(Column::Control, names.size());
        for (const std::string& name : names)
            columns_.text(Column::Control, name);
    };
    list(field_names<Registers>());
    list(field_names<DrawImageCommand>());
    list(field_names<ClearCommand>());
    list(field_names<CopyRectangleCommand>());
    list(field_names<Surface>());
    write_block(BlockKind::Names);
}

void WorkFileWriter::begin_item(Item item) {
    if (columns_.bytes() >= BlockBytes) write_block(BlockKind::Items);
    ++items_;
    if (item != Item::Quad && item != Item::Vertex && item != Item::Primitive && item != Item::Row)
        columns_.byte(Column::Control, static_cast<std::uint8_t>(item));
}

template <class Command>
void WorkFileWriter::write_fields(const Command& command) {
    field_values(command, values_);
    for (const std::uint32_t value : values_)
        columns_.number(Column::Control, value);
}

void WorkFileWriter::content(const std::shared_ptr<const SurfaceContent>& content) {
    begin_item(Item::SurfaceContent);
    write_fields(content->surface);
    const std::size_t row = row_bytes(content->surface.format, content->surface.width);
    std::vector<std::byte> before(row);
    for (auto rest = std::span(content->bytes); !rest.empty(); rest = rest.subspan(row)) {
        begin_item(Item::Row);
        write_row(columns_, rest.first(row), before);
        before.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(row));
    }
}

void WorkFileWriter::host_transfer(const HostTransfer& transfer) {
    begin_item(Item::HostTransfer);
    columns_.byte(Column::Control, transfer.is_write);
    columns_.number(Column::Control, transfer.at);
    columns_.number(Column::Control, transfer.bytes);
}

void WorkFileWriter::end_frame(std::uint32_t frame) {
    begin_item(Item::FrameEnd);
    columns_.number(Column::Control, frame);
}

void WorkFileWriter::frame(const FrameFigures& figures) {
    begin_item(Item::FrameFigures);
    columns_.number(Column::Control, figures.number);
    columns_.number(Column::Control, figures.width);
    columns_.number(Column::Control, figures.height);
    columns_.number(Column::Control, figures.api_calls);
    columns_.number(Column::Control, figures.functional.size());
    for (const auto& [name, value] : figures.functional) {
        columns_.text(Column::Control, name);
        columns_.number(Column::Control, value);
    }
}

void WorkFileWriter::command(std::shared_ptr<const WholeCommand> command) {
    const WorkDraw& draw = command->draw;
    begin_item(Item::Command);
    columns_.byte(Column::Control, static_cast<std::uint8_t>(draw.kind));
    columns_.number(Column::Control, draw.number);
    columns_.number(Column::Control, draw.frame);
    columns_.byte(Column::Control, draw.early_depth);
    columns_.number(Column::Control, draw.register_writes);
    columns_.number(Column::Control, draw.register_words);
    write_state(draw.state);
    if (draw.kind == WorkKind::Image) write_fields(draw.image);
    if (draw.kind == WorkKind::Clear) write_fields(draw.clear);
    if (draw.kind == WorkKind::Copy) write_fields(draw.copy);
    std::uint8_t units = 0;
    for (const std::uint8_t unit : command->units)
        units = static_cast<std::uint8_t>(units | 1u << unit);
    columns_.byte(Column::Control, units);
    columns_.number(Column::Control, command->quads.size());
    columns_.byte(Column::Control, command->has_values());
    if (draw.kind == WorkKind::Draw) write_geometry(draw.geometry);
    write_quads(*command);
}

// The fields that differ from those before: how many, then the steps to each, and its value.
void WorkFileWriter::write_state(const std::shared_ptr<const Registers>& state) {
    columns_.byte(Column::Control, state != nullptr);
    if (!state) return;
    if (state == state_) return columns_.number(Column::Control, 0);
    state_ = state;
    field_values(*state, values_);
    std::uint32_t changes = 0;
    for (std::size_t i = 0; i < values_.size(); ++i)
        changes += values_[i] != state_values_[i];
    columns_.number(Column::Control, changes);
    std::size_t last = 0;
    for (std::size_t i = 0; i < values_.size() && changes > 0; ++i) {
        if (values_[i] == state_values_[i]) continue;
        columns_.number(Column::Control, i - last);
        columns_.number(Column::Control, values_[i]);
        last = i;
        --changes;
    }
    std::swap(state_values_, values_);
}

void WorkFileWriter::write_geometry(const GeometryWork& geometry) {
    GeometryWork::for_each_number(
        geometry, [this](const auto& value) { columns_.number(Column::Control, value); });
    columns_.number(Column::Control, geometry.vertices.size());
    std::uint32_t last = ~0u; // The first step from here to 0 is 1.
    for (auto rest = std::span(geometry.vertices); !rest.empty();) {
        begin_item(Item::Vertex);
        const std::size_t count = items_of_block(rest.size(), MostOfVertex);
        std::uint8_t* to = columns_.room(Column::Vertex, count * MostOfVertex);
        for (const std::uint32_t vertex : rest.first(count)) {
            to = put_number(to, zigzag(static_cast<std::int32_t>(vertex - last - 1u)));
            last = vertex;
        }
        columns_.written(Column::Vertex, to);
        items_ += static_cast<std::uint32_t>(count - 1);
        rest = rest.subspan(count);
    }
    write_primitives(geometry);
}

// Of `left` items that are at hand, and take so many bytes at most, some that surely belong to the
// block.
std::size_t WorkFileWriter::items_of_block(std::size_t left, std::size_t most_bytes) const {
    const std::size_t count = std::min(left, QuadColumnWriter::MostQuads);
    return columns_.bytes() + count * most_bytes < BlockBytes ? count : 1;
}

void WorkFileWriter::write_primitives(const GeometryWork& geometry) {
    columns_.number(Column::Control, geometry.primitives.size());
    PrimitiveWork before{.key = ~0u};
    const PieceBox* piece = geometry.pieces.data();
    for (auto rest = std::span(geometry.primitives); !rest.empty();) {
        begin_item(Item::Primitive);
        std::size_t pieces = 0, count = 0;
        while (count < std::min(rest.size(), QuadColumnWriter::MostQuads))
            pieces += rest[count++].pieces;
        if (columns_.bytes() + count * MostOfPrimitive + pieces * MostOfPiece >= BlockBytes) {
            count = 1;
            pieces = rest[0].pieces;
        }
        write_assembly(rest.first(count), before);
        write_pieces({piece, pieces});
        before = rest[count - 1];
        piece += pieces;
        items_ += static_cast<std::uint32_t>(count - 1);
        rest = rest.subspan(count);
    }
}

void WorkFileWriter::write_assembly(std::span<const PrimitiveWork> primitives,
                                    PrimitiveWork before) {
    std::uint8_t* assembly = columns_.room(Column::Assembly, primitives.size() * MostOfPrimitive);
    std::uint8_t* outcome = columns_.room(Column::Outcome, primitives.size() * MostOfPrimitive);
    for (const PrimitiveWork& primitive : primitives) {
        check(primitive.key - before.key <= 1, "keys count the primitives");
        assembly = put_number(assembly, primitive.last_vertex - before.last_vertex);
        const bool clipped = primitive.planes != 0;
        const bool usual = primitive.pieces == (primitive.fate == PrimitiveFate::Drawn ? 1u : 0u);
        *outcome++ =
            static_cast<std::uint8_t>(static_cast<unsigned>(primitive.fate) |
                                      (primitive.key != before.key ? OutcomeNextKey : 0) |
                                      (clipped ? OutcomeClipped : 0) | (usual ? 0 : OutcomePieces));
        if (clipped) *outcome++ = primitive.planes;
        if (!usual) outcome = put_number(outcome, primitive.pieces);
        before = primitive;
    }
    columns_.written(Column::Assembly, assembly);
    columns_.written(Column::Outcome, outcome);
}

void WorkFileWriter::write_pieces(std::span<const PieceBox> pieces) {
    std::uint8_t* x = columns_.room(Column::PieceX, pieces.size() * MostOfPiece);
    std::uint8_t* y = columns_.room(Column::PieceY, pieces.size() * MostOfPiece);
    std::uint8_t* work = columns_.room(Column::PieceWork, pieces.size() * MostOfPiece);
    for (const PieceBox& box : pieces) {
        x = put_number(put_number(x, zigzag(box.x0 - box_.x0)), number_of(box.x1 - box.x0));
        y = put_number(put_number(y, zigzag(box.y0 - box_.y0)), number_of(box.y1 - box.y0));
        work = put_number(work, box.touched_blocks);
        work = put_number(work, box.planes);
        work = put_number(work, box.values);
        work = put_number(work, box.divisors * 4u + box.perspective * 2u + box.handed_on);
        box_ = box;
    }
    columns_.written(Column::PieceX, x);
    columns_.written(Column::PieceY, y);
    columns_.written(Column::PieceWork, work);
}

void WorkFileWriter::write_quads(const WholeCommand& command) {
    quads_out_.begin(command);
    for (std::size_t i = 0; i < command.quads.size();) {
        begin_item(Item::Quad);
        const std::size_t count = quads_of_block(command, i);
        quads_out_.write(command, i, count, columns_);
        items_ += static_cast<std::uint32_t>(count - 1);
        i += count;
    }
}

// From `first` on, some that surely belong to the block at hand.
std::size_t WorkFileWriter::quads_of_block(const WholeCommand& command, std::size_t first) const {
    const std::size_t count = std::min(command.quads.size() - first, QuadColumnWriter::MostQuads);
    const std::size_t most = quads_out_.most_bytes(command, first, count);
    return columns_.bytes() + most < BlockBytes ? count : 1;
}

void WorkFileWriter::write_block(BlockKind kind) {
    raw_.clear();
    for (std::size_t i = 0; i < ColumnCount; ++i) {
        const auto bytes = static_cast<std::uint32_t>(columns_.of(static_cast<Column>(i)).size());
        for (unsigned shift = 0; shift < 32; shift += 8)
            raw_.push_back(static_cast<std::uint8_t>(bytes >> shift));
    }
    for (std::size_t i = 0; i < ColumnCount; ++i) {
        const auto column = columns_.of(static_cast<Column>(i));
        raw_.insert(raw_.end(), column.begin(), column.end());
    }
    columns_.clear();
    packed_.resize(ZSTD_compressBound(raw_.size()));
    const std::size_t count =
        ZSTD_compress2(context_.get(), packed_.data(), packed_.size(), raw_.data(), raw_.size());
    check(!ZSTD_isError(count), "zstd compresses what fits its bound");
    const BlockHeader header{.kind = static_cast<std::uint32_t>(kind),
                             .items = std::exchange(items_, 0),
                             .raw_bytes = static_cast<std::uint32_t>(raw_.size()),
                             .packed_bytes = static_cast<std::uint32_t>(count)};
    file_.write(std::as_bytes(std::span(&header, 1)));
    file_.write(std::as_bytes(std::span(packed_)).first(count));
}

void WorkFileWriter::finish() {
    if (std::exchange(finished_, true)) return;
    if (items_ > 0) write_block(BlockKind::Items);
    write_block(BlockKind::End);
    file_.commit();
}

} // namespace ffgpu::work
