// Whole traces against the pictures that were agreed on, and against those of another renderer.

#include "model/gpu/functional_gpu.h"
#include "tests/system/trace_run.h"
#include "tools/frames/frame_source.h"
#include "tools/image/compare_images.h"
#include "tools/report/frame_image.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

const std::string GoldenPath = FFGPU_SOURCE_DIR "/tests/system/golden_frames.tsv";
const std::string GoldenHeader =
    "# The hash of each frame of each trace (64-bit FNV-1a of its RGB bytes, the top row first).\n"
    "# Traces under the name of workloads are those of real programs, not in this repository.\n"
    "# Only a deliberate change of the arithmetic changes a line; look at the pictures first, "
    "then\n"
    "# write this file anew by:  FFGPU_UPDATE_GOLDEN=1 build/tests/system_test '[golden]'\n"
    "trace\tframe\twidth\theight\thash\n";

using Golden = std::map<std::string, std::vector<Picture>>;

Golden read_golden() {
    Golden golden;
    std::ifstream file(GoldenPath);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#') || line.starts_with("trace\t")) continue;
        std::istringstream fields(line);
        std::string trace;
        Picture picture;
        fields >> trace >> picture.frame >> picture.width >> picture.height >> std::hex >>
            picture.hash;
        REQUIRE(fields);
        golden[trace].push_back(picture);
    }
    return golden;
}

void write_golden(const Golden& golden) {
    std::ofstream file(GoldenPath, std::ios::binary);
    file << GoldenHeader;
    for (const auto& [trace, pictures] : golden)
        for (const Picture& picture : pictures)
            file << fmt::format("{}\t{}\t{}\t{}\t{:016x}\n",
                                trace,
                                picture.frame,
                                picture.width,
                                picture.height,
                                picture.hash);
    REQUIRE(file.flush());
}

// The traces at hand: the name in the file of hashes, and the path.
std::map<std::string, std::string> traces() {
    std::map<std::string, std::string> paths;
    for (const std::string& name : own_traces())
        paths[name] = own_trace(name);
    std::vector<std::string> single = gallery_traces();
    single.emplace_back("tour");
    for (const std::string& name : single)
        paths[name] = own_trace(name);
    for (const std::string& name : workload_traces())
        paths["workloads/" + name] = workload_trace(name);
    return paths;
}

TEST_CASE("Each frame of each trace is the picture that was agreed on", "[golden]") {
    const bool update = std::getenv("FFGPU_UPDATE_GOLDEN") != nullptr;
    Golden golden = read_golden();
    for (const auto& [name, path] : traces()) {
        INFO(name);
        const std::vector<Picture> pictures = run_trace(path, {.threads = 2}).pictures;
        if (update) {
            golden[name] = pictures;
        } else {
            CHECK(pictures == golden[name]);
        }
    }
    if (update) write_golden(golden);
}

struct Limit {
    std::string trace;
    double max_rmse = 0, min_within_16 = 1;
};

// thresholds.tsv: how close a frame must come to the reference.
std::vector<Limit> limits() {
    std::vector<Limit> limits;
    std::ifstream file(workloads() / "thresholds.tsv");
    std::string line;
    std::getline(file, line); // the heading
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        Limit limit;
        if (fields >> limit.trace >> limit.max_rmse >> limit.min_within_16) limits.push_back(limit);
    }
    return limits;
}

TEST_CASE("Frames of real programs come as close to Mesa's as Mesa's two renderers do") {
    for (const Limit& limit : limits()) {
        FunctionalGpu gpu({.threads = 2});
        const auto source = open_frame_source(
            workload_trace(limit.trace), gpu, {.warn = [](const std::string&) {}});
        unsigned compared = 0;
        while (const auto frame = source->next()) {
            const auto reference = workloads() / "refs" / limit.trace /
                                   fmt::format("llvmpipe_frame{}.png", frame->number);
            if (!fs::exists(reference)) continue; // The first, where nothing is drawn yet.
            const Image expected = read_image(reference.string());
            const Image found = read_surface(gpu, frame->picture);
            INFO(limit.trace << " frame " << frame->number);
            REQUIRE(found.width == expected.width);
            REQUIRE(found.height == expected.height);
            const Difference difference = compare_images(found, expected);
            CHECK(difference.rmse <= limit.max_rmse);
            CHECK(difference.within_16 >= limit.min_within_16);
            ++compared;
        }
        INFO(limit.trace);
        CHECK(compared > 0);
    }
    if (limits().empty()) WARN("skipped: no references in " << workloads().string());
}

} // namespace
} // namespace ffgpu::tools
