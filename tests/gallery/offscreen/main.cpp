// gallery_offscreen: draws the gallery off-screen on ffgpu and compares it with the oracles.
//   --list                 a line a program: row, name, title, formula, tolerance, mutation, by
//   tabs NAME... -o DIR         DIR/NAME.ppm, DIR/NAME_oracle.ppm; a line of measured errors each
//   --break                the broken programs instead
//   --compare NAME A.ppm   another picture of the same program against its oracle

#include "model/base/input_error.h"
#include "tests/gallery/offscreen/draw.h"
#include "tests/gallery/offscreen/ppm.h"

#include <algorithm>
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

std::size_t find(const std::string& name) {
    const auto& all = programs();
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const Program& program) { return program.name == name; });
    if (found == all.end()) throw InputError("gallery: no program '" + name + "'; see --list");
    return static_cast<std::size_t>(found - all.begin());
}

void print(std::string_view text, char end) {
    std::printf("%.*s%c", static_cast<int>(text.size()), text.data(), end);
}

void list() {
    for (std::size_t i = 0; i < programs().size(); ++i) {
        const Program& program = programs()[i];
        const Claim& claim = claims()[i];
        for (const std::string_view text : {program.row,
                                            program.name,
                                            program.title,
                                            claim.formula,
                                            claim.reason,
                                            claim.mutation})
            print(text, '\t');
        std::printf("%g\t%g\t%g\n", claim.reach, claim.worst_allowed, claim.rms_allowed);
    }
}

void show(std::size_t i, const Options& options) {
    const Program& program = programs()[i];
    const Picture picture = options.compared.empty() ? draw_offscreen(program, options.broken)
                                                     : read_ppm(options.compared);
    const Difference found = difference(picture, claims()[i]);
    std::printf("%s\t%s\t%.2f\t%.3f\t%.3f\t%d,%d\t%s\n",
                std::string(program.row).c_str(),
                std::string(program.name).c_str(),
                found.worst,
                found.rms,
                found.rms_at_centres,
                found.worst_x,
                found.worst_y,
                holds(found, claims()[i]) ? "holds" : "fails");
    if (options.folder.empty()) return;
    std::filesystem::create_directories(options.folder);
    const std::string path = options.folder + "/" + std::string(program.name);
    write_ppm(path + ".ppm", picture);
    write_ppm(path + "_oracle.ppm", found.oracle);
}

int run(const std::vector<std::string>& arguments) {
    const Options options = parse(arguments);
    if (options.list) list();
    std::vector<std::size_t> chosen;
    for (const std::string& name : options.names)
        chosen.push_back(find(name));
    if (chosen.empty() && !options.list) {
        for (std::size_t i = 0; i < programs().size(); ++i)
            chosen.push_back(i);
    }
    for (const std::size_t i : chosen)
        show(i, options);
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
