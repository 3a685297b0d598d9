#include "tools/check/check_suite.h"

#include "model/base/input_error.h"
#include "tools/replay/replay.h"
#include "tools/report/statistics_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
        const fs::path name = entry.path().filename();
        if (name.string().starts_with("frame_") && name.extension() == ".png")
            names.insert(name.stem().string());
    }
    return names;
}

std::string verdict_text(const Difference& difference, const Tolerance& tolerance) {
    std::string text = fmt::format("rmse {:.3f} (at most {:g}), worst {} at ({}, {})",
                                   difference.rmse,
                                   tolerance.max_rmse,
                                   difference.worst_difference,
                                   difference.worst_x,
                                   difference.worst_y);
    if (tolerance.max_worst) text += fmt::format(" (at most {})", *tolerance.max_worst);
    return text;
}

class TraceCheck {
public:
    TraceCheck(const SuiteTrace& trace, const CheckOptions& options)
        : trace_(trace)
        , options_(options)
        , folder_(fs::path(options.output) / trace.name) {}

    std::vector<CheckedFrame> run() {
        make_folder(folder_.string());
        for (const std::string& older : pictures_in(folder_)) // They would pass for new ones.
            fs::remove(folder_ / (older + ".png"));
        if (const auto wrong = draw()) return {told(*wrong)};
        std::set<std::string> names = pictures_in(folder_);
        for (const std::string& name : pictures_in(trace_.reference))
            if (is_wanted(name)) names.insert(name);
        std::vector<CheckedFrame> frames;
        frames.reserve(names.size());
        for (const std::string& name : names)
            frames.push_back(told(check(name)));
        return frames;
    }

private:
    bool is_wanted(const std::string& name) const {
        return trace_.frames.contains(
            std::strtoull(name.c_str() + std::string("frame_").size(), nullptr, 10));
    }

    const CheckedFrame& told(const CheckedFrame& frame) const {
        options_.on_frame(frame);
        return frame;
    }

    // What went wrong.
    std::optional<CheckedFrame> draw() const {
        ReplayOptions replay_options;
        replay_options.input = trace_.input;
        replay_options.output = folder_.string();
        replay_options.frames = trace_.frames;
        replay_options.samples = trace_.samples;
        try {
            replay(replay_options);
        } catch (const InputError& error) {
            return CheckedFrame{
                trace_.name, "replay", Verdict::Error, error.what(), {}, "", "", ""};
        }
        if (!pictures_in(folder_).empty()) return std::nullopt;
        return CheckedFrame{
            trace_.name, "replay", Verdict::Error, "it shows no picture", {}, "", "", ""};
    }

    CheckedFrame check(const std::string& name) const {
        CheckedFrame frame;
        frame.trace = trace_.name;
        frame.name = name;
        const fs::path drawn = folder_ / (name + ".png");
        const fs::path reference = fs::path(trace_.reference) / (name + ".png");
        if (fs::exists(drawn)) frame.picture = in_output(name + ".png");
        try {
            if (options_.update) keep(drawn, reference);
            compare(drawn, reference, frame);
        } catch (const InputError& error) {
            frame.verdict = Verdict::Error;
            frame.message = error.what();
        }
        return frame;
    }

    void compare(const fs::path& drawn, const fs::path& reference, CheckedFrame& frame) const {
        const Image wanted = read_image(reference.string()), image = read_image(drawn.string());
        if (image.width != wanted.width || image.height != wanted.height) {
            frame.verdict = Verdict::Failed;
            frame.message = fmt::format("is {}x{}, the reference {}x{}",
                                        image.width,
                                        image.height,
                                        wanted.width,
                                        wanted.height);
        } else {
            const Difference difference = compare_images(image, wanted);
            const Tolerance& tolerance = trace_.tolerance;
            const bool passes = difference.rmse <= tolerance.max_rmse &&
                                difference.worst_difference <= tolerance.max_worst.value_or(255);
            frame.difference = difference;
            frame.message = verdict_text(difference, tolerance);
            frame.verdict = passes ? Verdict::Passed : Verdict::Failed;
        }
        if (frame.verdict == Verdict::Passed) return;
        frame.reference = in_output(frame.name + "_reference.png");
        write_png((fs::path(options_.output) / frame.reference).string(), wanted);
        if (!frame.difference) return;
        frame.difference_picture = in_output(frame.name + "_difference.png");
        write_png((fs::path(options_.output) / frame.difference_picture).string(),
                  difference_picture(image, wanted));
    }

    void keep(const fs::path& drawn, const fs::path& reference) const {
        make_folder(trace_.reference);
        write_png(reference.string(), read_image(drawn.string()));
    }

    std::string in_output(const std::string& name) const {
        return (fs::path(trace_.name) / name).string();
    }

    const SuiteTrace& trace_;
    const CheckOptions& options_;
    const fs::path folder_;
};

} // namespace

std::vector<CheckedFrame> check_suite(const Suite& suite, const CheckOptions& options) {
    std::vector<CheckedFrame> frames;
    for (const SuiteTrace& trace : suite.traces) {
        const std::vector<CheckedFrame> checked = TraceCheck(trace, options).run();
        frames.insert(frames.end(), checked.begin(), checked.end());
    }
    return frames;
}

} // namespace ffgpu::tools
