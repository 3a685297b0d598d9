#include "tools/check/check_suite.h"

#include "model/base/input_error.h"
#include "tools/replay/interruption.h"
#include "tools/replay/replay.h"
#include "tools/report/statistics_file.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view Prefix = "frame_";

// frame_0000.png, and frame_0000_reference.png beside it, without ".png".
std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
        const fs::path name = entry.path().filename();
        if (name.string().starts_with(Prefix) && name.extension() == ".png")
            names.insert(name.stem().string());
    }
    return names;
}

// Of "frame_0012"; nothing for a picture beside it.
std::optional<std::uint64_t> frame_number(const std::string& name) {
    std::uint64_t number = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + Prefix.size(), end, number);
    return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

// Where a path leads, whether or not it is there.
fs::path destination(const fs::path& path) {
    std::error_code error;
    const fs::path resolved = fs::weakly_canonical(path / ".", error);
    return error ? path : resolved;
}

// The pictures drawn must not become the references that they are compared with.
void check_folders(const Suite& suite, const fs::path& output) {
    for (const SuiteTrace& drawn : suite.traces)
        for (const SuiteTrace& trace : suite.traces)
            if (destination(output / drawn.name) == destination(trace.reference))
                throw InputError(
                    fmt::format("{}: holds the references of {}, which would be written over",
                                (output / drawn.name).string(),
                                trace.name));
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
        for (const std::string& older : pictures_in(folder_)) { // They would pass for new ones.
            std::error_code stays;                              // Told of where it is written over.
            fs::remove(folder_ / (older + ".png"), stays);
        }
        if (const auto wrong = draw()) return {told(*wrong)};
        std::set<std::string> names = pictures_in(folder_);
        const bool is_whole = Interruption::signal() == 0;
        if (is_whole)
            for (const std::string& name : pictures_in(trace_.reference))
                if (is_wanted(name)) names.insert(name);
        std::vector<CheckedFrame> frames;
        frames.reserve(names.size());
        for (const std::string& name : names)
            frames.push_back(told(check(name)));
        if (!is_whole) frames.push_back(told(not_drawn("interrupted: the rest is not drawn")));
        return frames;
    }

private:
    bool is_wanted(const std::string& name) const {
        const auto number = frame_number(name);
        return number && trace_.frames.contains(*number);
    }

    const CheckedFrame& told(const CheckedFrame& frame) const {
        options_.on_frame(frame);
        return frame;
    }

    CheckedFrame not_drawn(const std::string& why) const {
        return {trace_.name, "replay", Verdict::Error, why, {}, "", "", ""};
    }

    // What went wrong.
    std::optional<CheckedFrame> draw() const {
        ReplayOptions replay_options;
        replay_options.input = trace_.input;
        replay_options.output = folder_.string();
        replay_options.frames = trace_.frames;
        replay_options.samples = trace_.samples;
        replay_options.warn = [this](const std::string& line) {
            options_.warn(trace_.name + ": " + line);
        };
        if (Interruption::signal() != 0) return not_drawn("interrupted: not drawn");
        try {
            replay(replay_options);
        } catch (const OutputError&) {
            throw;
        } catch (const InputError& error) {
            return not_drawn(error.what());
        }
        if (!pictures_in(folder_).empty()) return std::nullopt;
        return not_drawn("it shows no picture");
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
        } catch (const OutputError&) {
            throw;
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
    check_folders(suite, options.output);
    std::vector<CheckedFrame> frames;
    for (const SuiteTrace& trace : suite.traces) {
        const std::vector<CheckedFrame> checked = TraceCheck(trace, options).run();
        frames.insert(frames.end(), checked.begin(), checked.end());
    }
    return frames;
}

} // namespace ffgpu::tools
