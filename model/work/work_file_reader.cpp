#include "model/work/work_file_reader.h"

#include "model/base/input_error.h"
#include "model/work/work_check.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <type_traits>
#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t LongestName = 256, MostNames = 1 << 16;

} // namespace

bool WorkFileReader::is_work_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file.seekg(0)) return false; // A pipe keeps its bytes.
    std::string magic(WorkFileMagic.size(), '\0');
    return file.read(magic.data(), static_cast<std::streamsize>(magic.size())) &&
           magic == WorkFileMagic;
}

WorkFileReader::WorkFileReader(const std::string& path)
    : blocks_(path) {
    if (!blocks_.next() || blocks_.kind() != BlockKind::Names)
        blocks_.fail("expected the names of the fields");
    try {
        register_places_ = read_names(field_names<Registers>());
        image_places_ = read_names(field_names<DrawImageCommand>());
        clear_places_ = read_names(field_names<ClearCommand>());
        copy_places_ = read_names(field_names<CopyRectangleCommand>());
        surface_places_ = read_names(field_names<Surface>());
        if (!in_.at_end()) throw DamagedItem("the block is damaged: it holds more than names");
    } catch (const DamagedItem& error) {
        blocks_.fail(error.what());
    }
    // The writer began with reset values, too: of the fields that it knew.
    FieldValues reset;
    field_values(Registers{}, reset);
    for (const std::uint32_t place : register_places_)
        file_values_.push_back(place == NotHere ? 0 : reset[place]);
}

WorkFileReader::Places WorkFileReader::read_names(const std::vector<std::string>& ours) {
    Places places(in_.number(Column::Control, MostNames));
    auto expected = ours.begin(); // The order is ours, but for what another version has or lacks.
    for (std::uint32_t& place : places) {
        const std::string name = in_.text(Column::Control, LongestName);
        auto found = expected;
        if (found == ours.end() || *found != name)
            found = std::find(ours.begin(), ours.end(), name);
        place = found == ours.end() ? NotHere : static_cast<std::uint32_t>(found - ours.begin());
        if (found != ours.end()) expected = found + 1;
    }
    return places;
}

bool WorkFileReader::begin_item() {
    while (items_left_ == 0) {
        // No checksum covers the number of items: one that is too small leaves some.
        if (!in_.at_end()) throw DamagedItem("it holds more than its items");
        if (over_ || !blocks_.next()) {
            over_ = true;
            return false;
        }
        if (blocks_.kind() != BlockKind::Items) throw DamagedItem("expected a block of items");
        items_left_ = blocks_.items();
    }
    --items_left_;
    return true;
}

void WorkFileReader::need_item() {
    if (!begin_item()) throw DamagedItem("the file ends within a command");
}

void WorkFileReader::play(CommandSink& sink,
                          const std::function<void(const FrameFigures&)>& frame) {
    while (!stopped_) {
        Content content;
        try {
            if (!begin_item()) return;
            content = read_item();
        } catch (const DamagedItem& error) {
            blocks_.fail(std::string("the block is damaged: ") + error.what());
        }
        if (auto* const command = std::get_if<std::shared_ptr<const WholeCommand>>(&content))
            sink.command(std::move(*command));
        else if (const auto* const held =
                     std::get_if<std::shared_ptr<const SurfaceContent>>(&content))
            sink.content(*held);
        else if (const auto* const transfer = std::get_if<HostTransfer>(&content))
            sink.host_transfer(*transfer);
        else if (const auto* const end = std::get_if<FrameEnd>(&content))
            sink.end_frame(end->frame);
        else
            frame(std::get<FrameFigures>(content));
    }
}

WorkFileReader::Content WorkFileReader::read_item() {
    switch (static_cast<Item>(in_.byte(Column::Control))) {
    case Item::Command:
        return read_command();
    case Item::HostTransfer: {
        HostTransfer transfer;
        transfer.is_write = in_.byte(Column::Control) != 0;
        transfer.at = in_.word(Column::Control);
        transfer.bytes = in_.number(Column::Control, Most32);
        return transfer;
    }
    case Item::FrameEnd:
        return FrameEnd{in_.word(Column::Control)};
    case Item::FrameFigures:
        return read_figures();
    case Item::SurfaceContent:
        return read_content();
    default:
        throw DamagedItem("there is no such item");
    }
}

FrameFigures WorkFileReader::read_figures() {
    FrameFigures figures;
    figures.number = in_.number(Column::Control);
    figures.width = in_.word(Column::Control);
    figures.height = in_.word(Column::Control);
    figures.api_calls = in_.number(Column::Control);
    const std::uint64_t count = in_.number(Column::Control, MostNames);
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string name = in_.text(Column::Control, LongestName);
        figures.functional.emplace_back(std::move(name), in_.number(Column::Control));
    }
    return figures;
}

template <class Command>
void WorkFileReader::read_fields(const Places& places, Command& command) {
    FieldValues values;
    field_values(command, values);
    for (const std::uint32_t place : places) {
        const std::uint32_t value = in_.word(Column::Control);
        if (place != NotHere) values[place] = value;
    }
    set_fields(values, command);
}

std::shared_ptr<const SurfaceContent> WorkFileReader::read_content() {
    auto content = std::make_shared<SurfaceContent>();
    Surface& surface = content->surface;
    read_fields(surface_places_, surface);
    try {
        check_surface(surface);
    } catch (const InputError& error) {
        throw DamagedItem(error.what());
    }
    std::vector<std::byte> row(row_bytes(surface.format, surface.width));
    for (std::uint32_t i = 0; i < std::uint32_t{surface.height} * surface.samples; ++i) {
        need_item();
        read_row(in_, row);
        content->bytes.insert(content->bytes.end(), row.begin(), row.end());
    }
    return content;
}

std::shared_ptr<const WholeCommand> WorkFileReader::read_command() {
    auto whole = std::make_shared<WholeCommand>();
    WorkDraw& draw = whole->draw;
    draw.kind = static_cast<WorkKind>(
        in_.number(Column::Control, static_cast<std::uint64_t>(WorkKind::Copy)));
    draw.number = in_.word(Column::Control);
    draw.frame = in_.word(Column::Control);
    draw.early_depth = in_.byte(Column::Control) != 0;
    draw.register_writes = in_.word(Column::Control);
    draw.register_words = in_.word(Column::Control);
    read_state(draw);
    if (draw.kind == WorkKind::Image) read_fields(image_places_, draw.image);
    if (draw.kind == WorkKind::Clear) read_fields(clear_places_, draw.clear);
    if (draw.kind == WorkKind::Copy) read_fields(copy_places_, draw.copy);
    try {
        check_draw(draw);
    } catch (const InputError& error) {
        throw DamagedItem(error.what());
    }
    const std::uint8_t units = in_.byte(Column::Control);
    for (std::uint8_t unit = 0; unit < TextureUnits; ++unit)
        if ((units >> unit & 1) != 0) whole->units.push_back(unit);
    const std::uint64_t quads = in_.number(Column::Control, Most32);
    if (in_.byte(Column::Control) != 0) whole->value_begin.push_back(0);
    if (draw.kind == WorkKind::Draw) read_geometry(draw.geometry);
    for (std::uint64_t i = 0; i < quads; ++i) {
        need_item();
        quads_.append_quad(*whole);
    }
    try {
        check_pieces(*whole);
    } catch (const InputError& error) {
        throw DamagedItem(error.what());
    }
    return whole;
}

void WorkFileReader::read_state(WorkDraw& draw) {
    if (in_.byte(Column::Control) == 0) return;
    const std::uint64_t changes = in_.number(Column::Control, file_values_.size());
    std::uint64_t at = 0;
    for (std::uint64_t i = 0; i < changes; ++i) {
        at += in_.number(Column::Control, file_values_.size());
        if (at >= file_values_.size()) throw DamagedItem("there is no such field");
        file_values_[at] = in_.word(Column::Control);
    }
    if (changes > 0 || !state_) {
        auto state = std::make_shared<Registers>();
        FieldValues values;
        field_values(*state, values);
        for (std::size_t i = 0; i < file_values_.size(); ++i)
            if (register_places_[i] != NotHere) values[register_places_[i]] = file_values_[i];
        set_fields(values, *state);
        state_ = std::move(state);
    }
    draw.state = state_;
}

void WorkFileReader::read_geometry(GeometryWork& geometry) {
    GeometryWork::for_each_number(geometry, [this](auto& value) {
        using Value = std::remove_reference_t<decltype(value)>;
        value = static_cast<Value>(in_.number(Column::Control, std::numeric_limits<Value>::max()));
    });
    const std::uint64_t count = in_.number(Column::Control, Most32);
    std::uint32_t last = ~0u;
    for (std::uint64_t i = 0; i < count; ++i) {
        need_item();
        last += static_cast<std::uint32_t>(in_.difference(Column::Vertex)) + 1;
        geometry.vertices.push_back(last);
    }
    read_primitives(geometry);
}

void WorkFileReader::read_primitives(GeometryWork& geometry) {
    const std::uint64_t count = in_.number(Column::Control, Most32);
    PrimitiveWork primitive{.key = ~0u};
    for (std::uint64_t i = 0; i < count; ++i) {
        need_item();
        primitive.last_vertex += in_.word(Column::Assembly);
        const std::uint8_t outcome = in_.byte(Column::Outcome);
        primitive.fate = static_cast<PrimitiveFate>(outcome & 3);
        primitive.key += (outcome & OutcomeNextKey) != 0;
        primitive.planes = (outcome & OutcomeClipped) != 0 ? in_.byte(Column::Outcome) : 0;
        primitive.pieces = primitive.fate == PrimitiveFate::Drawn;
        if ((outcome & OutcomePieces) != 0) primitive.pieces = in_.word(Column::Outcome);
        if (primitive.last_vertex >= geometry.vertices.size())
            throw DamagedItem("a primitive without its vertex");
        if (primitive.key == ~0u) throw DamagedItem("a primitive without a key");
        geometry.primitives.push_back(primitive);
        for (std::uint32_t piece = 0; piece < primitive.pieces; ++piece)
            geometry.pieces.push_back(read_piece());
    }
}

PieceBox WorkFileReader::read_piece() {
    const auto end = [](std::uint32_t begin, std::uint64_t size) {
        if (begin + size > MaxSurfaceSize)
            throw DamagedItem("a primitive lies outside any surface");
        return static_cast<std::uint16_t>(begin + size);
    };
    PieceBox box;
    box.x0 = moved(box_.x0, in_.difference(Column::PieceX));
    box.x1 = end(box.x0, in_.number(Column::PieceX, MaxSurfaceSize));
    box.y0 = moved(box_.y0, in_.difference(Column::PieceY));
    box.y1 = end(box.y0, in_.number(Column::PieceY, MaxSurfaceSize));
    if ((box.x0 == box.x1) != (box.y0 == box.y1)) throw DamagedItem("a box of pixels without area");
    constexpr std::uint64_t Blocks = MaxSurfaceSize / PieceBox::BlockWidth, MostPlanes = 0xff;
    const auto count = [&](std::uint64_t most) {
        return static_cast<std::uint8_t>(in_.number(Column::PieceWork, most));
    };
    box.touched_blocks = static_cast<std::uint32_t>(in_.number(Column::PieceWork, Blocks * Blocks));
    box.planes = count(MostPlanes);
    box.values = count(MostPlanes);
    const std::uint8_t divisors = count(MostPlanes);
    box.divisors = divisors / 4;
    box.perspective = (divisors & 2) != 0;
    box.handed_on = (divisors & 1) != 0;
    box_ = box;
    return box;
}

} // namespace ffgpu::work
