// WorkFileReader: plays a work file to whoever reads whole commands. It holds one command and a
// block. Fields of registers and commands are found by their names: one that the file does not
// know keeps its reset value, one that only the file knows is passed over.

#pragma once

#include "model/work/frame_figures.h"
#include "model/work/whole_command.h"
#include "model/work/work_fields.h"
#include "model/work/work_file_blocks.h"
#include "model/work/work_file_quads.h"

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace ffgpu::work {

class WorkFileReader {
public:
    // False also where the file cannot be read: its reader says why.
    static bool is_work_file(const std::string& path);

    // Throws InputError, as play(), with one line that names the file and the byte.
    explicit WorkFileReader(const std::string& path);

    // All of it. `frame` is called where a measured frame's work has all been handed over.
    void play(CommandSink& sink, const std::function<void(const FrameFigures&)>& frame);

    // For `frame` to call: play() returns behind it, whatever follows in the file.
    void stop() { stopped_ = true; }

private:
    struct FrameEnd {
        std::uint32_t frame = 0;
    };
    using Content = std::variant<std::shared_ptr<const WholeCommand>,
                                 std::shared_ptr<const SurfaceContent>,
                                 HostTransfer,
                                 FrameEnd,
                                 FrameFigures>;

    // The place of each of the file's fields here; NotHere: it has none.
    using Places = std::vector<std::uint32_t>;
    static constexpr std::uint32_t NotHere = ~0u;

    Places read_names(const std::vector<std::string>& ours);
    bool begin_item(); // False: the file is over.
    void need_item();
    Content read_item();
    std::shared_ptr<const WholeCommand> read_command();
    void read_state(WorkDraw& draw);
    void read_geometry(GeometryWork& geometry);
    void read_primitives(GeometryWork& geometry);
    PieceBox read_piece();
    FrameFigures read_figures();
    std::shared_ptr<const SurfaceContent> read_content();
    template <class Command>
    void read_fields(const Places& places, Command& command);

    WorkFileBlocks blocks_;
    ColumnReader& in_ = blocks_.columns();
    std::uint32_t items_left_ = 0;
    bool over_ = false, stopped_ = false;
    Places register_places_, image_places_, clear_places_, copy_places_, surface_places_;
    std::shared_ptr<const Registers> state_; // the last read
    FieldValues file_values_;                // of the file's fields of registers
    PieceBox box_;                           // the last read
    WorkFileQuads quads_{in_};
};

} // namespace ffgpu::work
