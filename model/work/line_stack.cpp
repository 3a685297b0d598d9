#include "model/work/line_stack.h"

namespace ffgpu::work {

std::uint32_t LineStack::use(std::uint32_t id, bool write) {
    if (tree_.is_full()) make_room();
    Line& used = line(id);
    const std::uint32_t position = used.time == NotThere ? NotThere : tree_.after(used.time);
    if (position == NotThere)
        used.level = write ? 0 : WriteBacks::Clean;
    else
        used.level = write_backs_.used(used.level, position, write);
    take_off(used.time);
    put_on(id);
    return position;
}

void LineStack::put_on(std::uint32_t id) {
    const std::uint32_t time = tree_.add();
    if (time >= owners_.size()) owners_.resize(std::size_t{time} * 2 + 64);
    owners_[time] = id;
    lines_[id].time = time;
}

std::uint32_t LineStack::take(std::uint32_t id) {
    Line& taken = line(id);
    const std::uint32_t position = taken.time == NotThere ? NotThere : tree_.after(taken.time);
    take_off(taken.time);
    taken.time = NotThere;
    return position;
}

void LineStack::put(std::uint32_t id) {
    if (tree_.is_full()) make_room();
    line(id);
    put_on(id);
}

// The uppermost hole above the line, if there is one, is filled, and the line's place is one then.
void LineStack::take_off(std::uint32_t time) {
    const bool was_there = time != NotThere;
    if (holes_.empty() || (was_there && holes_.top() < time)) {
        if (was_there) tree_.clear(time);
        return;
    }
    tree_.clear(holes_.top());
    holes_.pop();
    if (!was_there) return;
    owners_[time] = Hole;
    holes_.push(time);
}

void LineStack::drop(std::uint32_t id, bool whole) {
    if (!has(id)) return;
    Line& dropped = lines_[id];
    whole ? write_backs_.overwritten(dropped.level, tree_.after(dropped.time))
          : write_backs_.left(dropped.level);
    owners_[dropped.time] = Hole;
    holes_.push(dropped.time);
    dropped = {};
}

void LineStack::flush() {
    tree_.for_each_newest_first([&](std::uint32_t time) {
        if (owners_[time] == Hole) return;
        Line& flushed = lines_[owners_[time]];
        write_backs_.left(flushed.level);
        flushed = {};
    });
    tree_.reset();
    holes_ = {};
}

void LineStack::make_room() {
    std::vector<std::uint32_t> holes;
    tree_.renumber([&](std::uint32_t old, std::uint32_t time) {
        owners_[time] = owners_[old];
        if (owners_[time] == Hole)
            holes.push_back(time);
        else
            lines_[owners_[time]].time = time;
    });
    holes_ = std::priority_queue<std::uint32_t>({}, std::move(holes));
}

} // namespace ffgpu::work
