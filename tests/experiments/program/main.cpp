// experiments -o DIR [ID...]: runs the experiments, all or those named, and writes
// DIR/experiments.md and their plots. Exit status 0: all is met; 1: a tolerance failed; 2: bad
// usage.

#include "model/base/input_error.h"
#include "model/base/whole_file.h"
#include "tests/experiments/figures/all.h"
#include "tests/experiments/page/page.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace ffgpu::experiments {
namespace {

constexpr const char* Folder = "experiments"; // of the plots, beside the page

struct Arguments {
    std::string output;
    std::vector<std::string> ids;
};

Arguments parse(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "-o" && i + 1 < count) {
            arguments.output = words[++i];
        } else if (std::any_of(
                       All.begin(), All.end(), [&](const Entry& e) { return e.id == word; })) {
            arguments.ids.push_back(word);
        } else {
            throw InputError("there is no experiment '" + word +
                             "'; there are P1 to P10, P12 to P15");
        }
    }
    if (arguments.output.empty()) throw InputError("-o DIR is missing");
    return arguments;
}

bool is_wanted(const Arguments& arguments, std::string_view id) {
    return arguments.ids.empty() ||
           std::find(arguments.ids.begin(), arguments.ids.end(), id) != arguments.ids.end();
}

void write(const std::string& path, const std::string& text) {
    WholeFile file(path);
    file.write(text);
    file.commit();
}

void write_plots(const Experiment& experiment, const std::filesystem::path& folder) {
    for (const Plot& plot : experiment.plots) {
        const std::string path = folder / plot.name;
        plot.svg.empty() ? tools::write_png(path + ".png", plot.picture)
                         : write(path + ".svg", plot.svg);
    }
}

int run(const Arguments& arguments) {
    const std::filesystem::path output = arguments.output;
    std::filesystem::create_directories(output / Folder);
    std::vector<Experiment> done;
    Score sum;
    for (const Entry& entry : All) {
        if (!is_wanted(arguments, entry.id)) continue;
        done.push_back(entry.run());
        sum += score(done.back());
        write_plots(done.back(), output / Folder);
        std::printf("%s\n", score_line(done.back().id, score(done.back())).c_str());
        std::fflush(stdout);
    }
    write(output / "experiments.md", page(done, Folder));
    std::printf("%s\n", score_line("all", sum).c_str());
    return sum.failed > 0 ? 1 : 0;
}

} // namespace
} // namespace ffgpu::experiments

int main(int count, char** words) {
    try {
        return ffgpu::experiments::run(ffgpu::experiments::parse(count, words));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "experiments: %s\n", error.what());
        return 2;
    }
}
