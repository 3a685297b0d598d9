// ImageWriter: writes PNG files on a thread of its own, so that compressing one picture and drawing
// the next happen at once. Few pictures wait; whoever adds more waits himself.

#pragma once

#include "tools/image/image.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace ffgpu::tools {

class ImageWriter {
public:
    ImageWriter();
    ~ImageWriter(); // What was added gets written.
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;

    // Throws what an earlier write has thrown; nothing is written behind that.
    void add(std::string path, Image image);

    // Throws what an earlier write has thrown.
    void check_failure();

    // Returns when everything is written; throws if something could not be.
    void finish();

private:
    static constexpr std::size_t MaxWaiting = 4;

    void run();
    void throw_failure();

    struct Job {
        std::string path;
        Image image;
    };
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_; // The first is being written.
    bool ending_ = false;
    std::exception_ptr failure_;
    std::thread thread_; // The last member: it uses the others.
};

} // namespace ffgpu::tools
