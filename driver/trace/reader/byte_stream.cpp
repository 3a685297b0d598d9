#include "driver/trace/reader/byte_stream.h"

namespace ffgpu::trace {

void ByteStream::rewind() {
    container_->rewind();
    chunk_.clear();
    at_ = end_ = chunk_.data();
    chunk_start_ = 0;
}

bool ByteStream::next_chunk() {
    chunk_start_ += chunk_.size();
    const auto begin_chunk = [this] {
        at_ = chunk_.data();
        end_ = at_ + chunk_.size();
    };
    try {
        do {
            const bool more = container_->next(chunk_);
            begin_chunk();
            if (!more) return false;
        } while (at_ == end_); // An empty block is legal.
    } catch (...) {
        chunk_.clear(); // The place that is told is where it would begin.
        begin_chunk();
        throw;
    }
    return true;
}

void ByteStream::need_chunk() {
    if (!next_chunk()) throw Damage{"the trace ends here"};
}

} // namespace ffgpu::trace
