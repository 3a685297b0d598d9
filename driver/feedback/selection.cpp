#include "driver/feedback/selection.h"

#include <algorithm>

namespace ffgpu::gl {

namespace {

// Window depth [0, 1] to the whole range of an unsigned word.
GLuint depth_word(float depth) {
    const double clamped = std::clamp(static_cast<double>(depth), 0.0, 1.0);
    return static_cast<GLuint>(clamped * 4294967295.0 + 0.5);
}

} // namespace

void Selection::start() {
    names_.clear();
    written_ = 0;
    records_ = 0;
    overflow_ = false;
    hit_ = false;
}

GLint Selection::finish() {
    end_record();
    const GLint result = overflow_ ? -1 : records_;
    names_.clear();
    return result;
}

void Selection::init_names() {
    end_record();
    names_.clear();
}

void Selection::load_name(GLuint name) {
    end_record();
    names_.back() = name;
}

void Selection::push_name(GLuint name) {
    end_record();
    names_.push_back(name);
}

void Selection::pop_name() {
    end_record();
    names_.pop_back();
}

void Selection::hit(float depth) {
    nearest_ = hit_ ? std::min(nearest_, depth) : depth;
    farthest_ = hit_ ? std::max(farthest_, depth) : depth;
    hit_ = true;
}

void Selection::end_record() {
    if (!hit_) return;
    hit_ = false;
    write(static_cast<GLuint>(names_.size()));
    write(depth_word(nearest_));
    write(depth_word(farthest_));
    for (const GLuint name : names_)
        write(name);
    if (!overflow_) ++records_;
}

void Selection::write(GLuint word) {
    if (written_ >= static_cast<std::size_t>(size_)) {
        overflow_ = true;
        return;
    }
    buffer_[written_++] = word;
}

} // namespace ffgpu::gl
