#include "model/work/miss_classifier.h"

#include <algorithm>
#include <utility>

namespace ffgpu::work {
namespace {

constexpr std::size_t FirstPages = 64; // a power of two

// D. E. Knuth's multiplicative hash: 2^64 over the golden ratio.
std::size_t hash(std::uint64_t page) {
    return static_cast<std::size_t>((page * 0x9e3779b97f4a7c15u) >> 20);
}

} // namespace

MissClassifier::MissClassifier(std::uint32_t sets, std::uint32_t ways)
    : capacity_(std::size_t{sets} * ways)
    , fully_associative_(sets == 1)
    , nodes_(1)
    , pages_(FirstPages) {}

MissKind MissClassifier::access(std::uint64_t line) {
    shadow_missed_ = false;
    const std::uint32_t newest = nodes_[0].after;
    if (newest != 0 && nodes_[newest].line == line) return kind_beside_shadow();
    std::uint32_t node = 0;
    const MissKind kind = find_or_take(line, node);
    link_first(node);
    return kind;
}

MissKind MissClassifier::access_first(std::uint64_t line, std::size_t place) {
    std::uint32_t& first = first_[place];
    if (first != 0) link_first(first);
    return find_or_take(line, first);
}

// The line's node, which is in no list then.
MissKind MissClassifier::find_or_take(std::uint64_t line, std::uint32_t& node) {
    std::uint32_t& here = node_of(line);
    const std::uint32_t before = here;
    shadow_missed_ = before == Nowhere || before == Untouched;
    if (!shadow_missed_) {
        unlink(before);
        node = before;
        return kind_beside_shadow();
    }
    node = here = take_node();
    nodes_[node].line = line;
    return before == Untouched ? MissKind::Compulsory : MissKind::Capacity;
}

void MissClassifier::flush() {
    nodes_.assign(1, {});
    free_nodes_.clear();
    first_.fill(0);
    pages_.assign(FirstPages, {});
    page_count_ = 0;
}

void MissClassifier::drop(std::uint64_t line) {
    Page& page = pages_[place_of(line / PageLines)];
    if (page.number != line / PageLines) return;
    const std::uint32_t node = std::exchange(page.nodes[line % PageLines], Untouched);
    if (node == Nowhere || node == Untouched) return;
    if (const auto first = std::ranges::find(first_, node); first != first_.end())
        *first = 0;
    else
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
    node_of(nodes_[oldest].line) = Nowhere;
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

// Where the page is, or would be.
std::size_t MissClassifier::place_of(std::uint64_t page) const {
    const std::size_t mask = pages_.size() - 1;
    std::size_t at = hash(page) & mask;
    while (pages_[at].number != NoPage && pages_[at].number != page)
        at = (at + 1) & mask;
    return at;
}

// Of a line whose page may have to be made. Later calls may move it.
std::uint32_t& MissClassifier::node_of(std::uint64_t line) {
    const std::uint64_t number = line / PageLines;
    Page* page = &pages_[place_of(number)];
    if (page->number != number) {
        if (2 * (page_count_ + 1) > pages_.size()) {
            grow();
            page = &pages_[place_of(number)];
        }
        ++page_count_;
        page->number = number;
        page->nodes.fill(Untouched);
    }
    return page->nodes[line % PageLines];
}

void MissClassifier::grow() {
    std::vector<Page> old(2 * pages_.size());
    old.swap(pages_);
    for (const Page& page : old) {
        if (page.number != NoPage) pages_[place_of(page.number)] = page;
    }
}

} // namespace ffgpu::work
