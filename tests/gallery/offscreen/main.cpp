// gallery_offscreen: draws the gallery off-screen on ffgpu and compares it with the oracles.
//   --list                 a line a program: row, name, title, formula, reason, mutation, reach,
//                          tolerances, supersampling, by tabs
//   NAME... -o DIR         DIR/NAME.ppm, DIR/NAME_oracle.ppm; a line of measured errors each
//   --break                the broken programs instead
//   --compare NAME A.ppm   another picture of the same program against its oracle

#include "model/base/input_error.h"
#include "tests/gallery/offscreen/draw.h"
#include "tests/gallery/offscreen/ppm.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace ffgpu::gallery {
namespace {

struct Options {
    bool list = false, broken = false;
    std::string folder;
    std::string compared; // a picture
    std::vector<std::string> names;
};

Options parse(const std::vector<std::string>& arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        const bool last = i + 1 == arguments.size();
        if (argument == "--list")
            options.list = true;
        else if (argument == "--break")
            options.broken = true;
        else if (argument == "-o" && !last)
            options.folder = arguments[++i];
        else if (argument == "--compare" && !last)
            options.compared = arguments[++i];
        else
            options.names.push_back(argument);
    }
    return options;
}

const Program* find(const std::string& name) {
    const Program* const program = find_program(name);
    if (!program) throw InputError("gallery: no program '" + name + "'; see --list");
    return program;
}

void print(std::string_view text, char end) {
    std::printf("%.*s%c", static_cast<int>(text.size()), text.data(), end);
}

void list(const std::vector<Program>& some) {
    for (const Program& program : some) {
        const Claim& claim = claim_of(program.row);
        for (const std::string_view text : {program.row,
                                            program.name,
                                            program.title,
                                            claim.formula,
                                            claim.reason,
                                            claim.mutation})
            print(text, '\t');
        std::printf("%g\t%g\t%g\t%u\n",
                    claim.reach,
                    claim.worst_allowed,
                    claim.rms_allowed,
                    program.supersampling);
    }
}

void show(const Program& program, const Options& options) {
    const Claim& claim = claim_of(program.row);
    const Picture picture = options.compared.empty() ? draw_offscreen(program, options.broken)
                                                     : read_ppm(options.compared);
    const Difference found = difference(picture, claim);
    print(program.row, '\t');
    print(program.name, '\t');
    std::printf("%.2f\t%.3f\t%.3f\t%d,%d\t%s\n",
                found.worst,
                found.rms,
                found.rms_at_centres,
                found.worst_x,
                found.worst_y,
                holds(found, claim) ? "holds" : "fails");
    if (options.folder.empty()) return;
    std::filesystem::create_directories(options.folder);
    const std::string path = options.folder + "/" + std::string(program.name);
    write_ppm(path + ".ppm", picture);
    write_ppm(path + "_oracle.ppm", found.oracle);
}

int run(const std::vector<std::string>& arguments) {
    const Options options = parse(arguments);
    if (options.list) {
        list(programs());
        list(filter_strip());
        return 0;
    }
    for (const std::string& name : options.names)
        show(*find(name), options);
    if (!options.names.empty()) return 0;
    for (const Program& program : programs())
        show(program, options);
    if (options.broken) return 0;
    for (const Program& program : filter_strip())
        show(program, options);
    return 0;
}

} // namespace
} // namespace ffgpu::gallery

int main(int count, char** values) {
    try {
        return ffgpu::gallery::run(std::vector<std::string>(values + 1, values + count));
    } catch (const ffgpu::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
