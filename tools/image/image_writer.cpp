#include "tools/image/image_writer.h"

#include "model/base/thread_without_signals.h"

#include <utility>

namespace ffgpu::tools {

ImageWriter::ImageWriter()
    : thread_(thread_without_signals([this] { run(); })) {}

ImageWriter::~ImageWriter() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void ImageWriter::add(std::string path, Image image) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.size() < MaxWaiting; });
    throw_failure();
    jobs_.push_back({std::move(path), std::move(image)});
    changed_.notify_all();
}

void ImageWriter::check_failure() {
    const std::lock_guard lock(mutex_);
    throw_failure();
}

void ImageWriter::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.empty(); });
    throw_failure();
}

void ImageWriter::throw_failure() {
    if (failure_) std::rethrow_exception(failure_);
}

void ImageWriter::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
        if (jobs_.empty()) return;
        const Job& job = jobs_.front(); // A deque's elements stay where they are.
        lock.unlock();
        std::exception_ptr failure;
        try {
            write_png(job.path, job.image);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        jobs_.pop_front();
        if (failure) {
            failure_ = failure;
            jobs_.clear();
        }
        changed_.notify_all();
    }
}

} // namespace ffgpu::tools
