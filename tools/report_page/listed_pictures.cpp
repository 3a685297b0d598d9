#include "tools/report_page/listed_pictures.h"

#include "tools/report/picture_list.h"
#include "tools/report_page/csv_table.h"

#include <filesystem>
#include <map>
#include <sstream>

namespace ffgpu::tools {
namespace {

// Compares a line of the list with what stats.json tells of the frame.
class SameRun {
public:
    SameRun(const CsvTable& file, const RunFigures& figures)
        : file_(file)
        , figures_(figures)
        , covered_(file.wanted_column("fragments_covered"))
        , written_(file.wanted_column("fragments_written"))
        , cycles_(file.wanted_column("total_cycles")) {}

    // Pictures of a run that was not timed depend on no machine.
    bool operator()(std::size_t line, std::size_t frame) const {
        const std::uint64_t cycles = file_.number(line, cycles_);
        return file_.number(line, covered_) == functional("fragments_covered", frame) &&
               file_.number(line, written_) == functional("fragments_written", frame) &&
               (cycles == 0 || cycles == figures_.frame_cycles(frame));
    }

private:
    std::uint64_t functional(const char* name, std::size_t frame) const {
        const FigureColumn* const column = find_figure(figures_.functional, name);
        return column ? (*column)[frame] : 0;
    }

    const CsvTable& file_;
    const RunFigures& figures_;
    const std::size_t covered_, written_, cycles_;
};

} // namespace

ListedPictures::ListedPictures(const std::string& folder, const RunFigures& figures) {
    const auto file = CsvTable::read((std::filesystem::path(folder) / PictureListName).string());
    if (!file) return;
    std::map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < figures.frames.size(); ++i)
        places[figures.frames[i].number] = i;
    const SameRun is_same_run(*file, figures);
    const std::size_t frame = file->wanted_column("frame");
    const std::size_t pictures = file->wanted_column("pictures");
    listed_.emplace();
    for (std::size_t line = 0; line < file->rows(); ++line) {
        const auto place = places.find(file->number(line, frame));
        if (place == places.end() || !is_same_run(line, place->second)) continue;
        std::istringstream names{std::string(file->text(line, pictures))};
        for (std::string name; names >> name;)
            listed_->emplace(place->second, name);
    }
}

} // namespace ffgpu::tools
