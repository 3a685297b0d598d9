#include "model/base/input_error.h"
#include "tools/commands/commands.h"
#include "tools/image/compare_images.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string a, b, difference;
    std::optional<double> max_rmse;
};

std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (!entry.is_directory() && entry.path().extension() == ".png") // A link to nothing, too.
            names.insert(entry.path().filename().string());
    return names;
}

// The RMSE; nothing if the sizes differ.
std::optional<double>
compare_files(const fs::path& a, const fs::path& b, const fs::path& difference) {
    const Image first = read_image(a.string()), second = read_image(b.string());
    const std::string name = a.filename().string();
    if (first.width != second.width || first.height != second.height) {
        fmt::print("{}: sizes differ: {}x{} and {}x{}\n",
                   name,
                   first.width,
                   first.height,
                   second.width,
                   second.height);
        return std::nullopt;
    }
    const Difference result = compare_images(first, second);
    fmt::print("{}: rmse {:.3f}, psnr {:.2f} dB, within 16: {:.2f} %, worst {} at ({}, {})\n",
               name,
               result.rmse,
               result.psnr,
               100 * result.within_16,
               result.worst_difference,
               result.worst_x,
               result.worst_y);
    if (!difference.empty()) write_png(difference.string(), difference_picture(first, second));
    return result.rmse;
}

int run_compare(const Arguments& arguments) {
    const fs::path a = arguments.a, b = arguments.b;
    for (const fs::path& path : {a, b})
        if (!fs::exists(path)) throw InputError(path.string() + ": does not exist");
    if (fs::is_directory(a) != fs::is_directory(b))
        throw InputError("compare: expected two pictures or two folders");
    const double limit = arguments.max_rmse.value_or(0);
    if (!(limit >= 0)) throw InputError("--max-rmse: expected a number from 0");
    const auto passes = [&](std::optional<double> rmse) { return rmse && *rmse <= limit; };
    if (!fs::is_directory(a)) return passes(compare_files(a, b, arguments.difference)) ? 0 : 1;

    if (!arguments.difference.empty())
        throw InputError("compare: --diff goes with two pictures, not folders");
    bool all_pass = true;
    const std::set<std::string> names = pictures_in(a), others = pictures_in(b);
    if (names.empty()) throw InputError(a.string() + ": holds no pictures (*.png)");
    for (const std::string& name : names)
        if (others.contains(name)) all_pass &= passes(compare_files(a / name, b / name, {}));
    for (const std::string& name : names)
        if (!others.contains(name))
            all_pass = (fmt::print("{}: only in {}\n", name, a.string()), false);
    for (const std::string& name : others)
        if (!names.contains(name))
            all_pass = (fmt::print("{}: only in {}\n", name, b.string()), false);
    return all_pass ? 0 : 1;
}

} // namespace

void add_compare_command(CLI::App& application, Run& run) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const verb =
        application.add_subcommand("compare", "Compares two pictures, or two folders of pictures");
    verb->add_option("a", arguments->a, "A picture or a folder")->required();
    verb->add_option("b", arguments->b, "The other one")->required();
    verb->add_option("--max-rmse",
                     arguments->max_rmse,
                     "Fail above this root mean square error, 0 to 255 (default 0)")
        ->type_name("X");
    verb->add_option("--diff", arguments->difference, "Write the difference, times 8")
        ->type_name("OUT.png");
    verb->footer(
        "Example: ffgpu compare out/frame_0001.png reference.png --max-rmse 2 --diff d.png");
    verb->callback([arguments, &run] { run = [arguments] { return run_compare(*arguments); }; });
}

} // namespace ffgpu::tools
