#include "model/work/miss_classifier.h"

#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t FirstEntries = 1024; // a power of two
constexpr std::uint64_t NoLine = ~std::uint64_t{0};

// D. E. Knuth's multiplicative hash: 2^64 over the golden ratio.
std::size_t hash(std::uint64_t line) {
    return static_cast<std::size_t>((line * 0x9e3779b97f4a7c15u) >> 20);
}

} // namespace

MissClassifier::MissClassifier(std::uint32_t sets, std::uint32_t ways)
    : capacity_(std::size_t{sets} * ways)
    , fully_associative_(sets == 1)
    , nodes_(1)
    , entries_(FirstEntries) {}

MissKind MissClassifier::access(std::uint64_t line) {
    shadow_missed_ = false;
    const std::uint32_t newest = nodes_[0].after;
    if (newest != 0 && nodes_[newest].line == line)
        return fully_associative_ ? MissKind::Capacity : MissKind::Conflict;

    Entry& entry = entry_of(line);
    const std::uint32_t before = entry.node;
    if (before != Nowhere && before != Untouched) {
        unlink(before);
        link_first(before);
        return fully_associative_ ? MissKind::Capacity : MissKind::Conflict;
    }
    shadow_missed_ = true;
    const std::uint32_t node = take_node();
    entry.node = node;
    nodes_[node].line = line;
    link_first(node);
    return before == Untouched ? MissKind::Compulsory : MissKind::Capacity;
}

void MissClassifier::flush() {
    nodes_.assign(1, {});
    free_nodes_.clear();
    entries_.assign(FirstEntries, {});
    entry_count_ = 0;
}

void MissClassifier::drop(std::uint64_t line) {
    Entry& entry = entries_[place_of(line)];
    if (entry.line != line) return;
    const std::uint32_t node = std::exchange(entry.node, Untouched);
    if (node == Nowhere || node == Untouched) return;
    unlink(node);
    free_nodes_.push_back(node);
}

// A node for one more line: the least recently used one's where the shadow is full.
std::uint32_t MissClassifier::take_node() {
    if (!free_nodes_.empty()) {
        const std::uint32_t node = free_nodes_.back();
        free_nodes_.pop_back();
        return node;
    }
    if (nodes_.size() <= capacity_) {
        nodes_.emplace_back();
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    const std::uint32_t oldest = nodes_[0].before;
    unlink(oldest);
    entry_of(nodes_[oldest].line).node = Nowhere;
    return oldest;
}

void MissClassifier::unlink(std::uint32_t node) {
    nodes_[nodes_[node].before].after = nodes_[node].after;
    nodes_[nodes_[node].after].before = nodes_[node].before;
}

void MissClassifier::link_first(std::uint32_t node) {
    const std::uint32_t second = nodes_[0].after;
    nodes_[node].before = 0;
    nodes_[node].after = second;
    nodes_[second].before = node;
    nodes_[0].after = node;
}

// Where the line's entry is, or would be.
std::size_t MissClassifier::place_of(std::uint64_t line) const {
    const std::size_t mask = entries_.size() - 1;
    std::size_t at = hash(line) & mask;
    while (entries_[at].line != NoLine && entries_[at].line != line)
        at = (at + 1) & mask;
    return at;
}

// The entry of a line, made as Untouched where there is none. Later calls may move it.
MissClassifier::Entry& MissClassifier::entry_of(std::uint64_t line) {
    const std::size_t at = place_of(line);
    if (entries_[at].line == line) return entries_[at];
    if (2 * (entry_count_ + 1) > entries_.size()) {
        grow();
        return entry_of(line);
    }
    ++entry_count_;
    entries_[at] = {line, Untouched};
    return entries_[at];
}

void MissClassifier::grow() {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old) {
        if (entry.line != NoLine) entries_[place_of(entry.line)] = entry;
    }
}

} // namespace ffgpu::work
